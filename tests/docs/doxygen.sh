# SPDX-License-Identifier: MIT
# sh doxygen.sh <build>: what the target `docs` runs writes the reference without a warning (a warning fails it), and
# what people look for is in it: the README as its main page, the manual with its pictures and links, classes, members,
# groups, examples.
set -u
docs=$1/docs
html=$docs/html
command -v doxygen >/dev/null && [ -f "$docs/Doxyfile" ] || { echo "skipped: no doxygen (Debian package doxygen)"; exit 77; }
failures=0

fail() {
    echo "$*"
    failures=$((failures + 1))
}
page_has() { # page, text
    grep -qF -- "$2" "$html/$1" 2>/dev/null || fail "$1 lacks: $2"
}
page_has_not() { # page, text
    grep -qF -- "$2" "$html/$1" && fail "$1 has: $2"
}

rm -rf "$html"
doxygen "$docs/Doxyfile" || exit 1

page_has index.html "Robots that learn in tens of trials"
page_has index.html 'data="arena.svg"'
page_has index.html 'href="adaptive.html"'
page_has index.html 'href="index.html#readme-the-paper"'
page_has index.html 'href="02_your_own_robot_8cpp-example.html"'
page_has adaptive.html 'data="adaptive-search.svg"'
page_has adaptive.html 'href="teaching.html"'
page_has teaching.html 'href="03_a_trainer_8cpp-example.html"'
page_has 01_first_steps_8cpp-example.html run_episodes
page_has classsspql_1_1Agent.html "observations in, commands out"
page_has classsspql_1_1AdaptiveSspql.html "The adaptive planner"
page_has classsspql_1_1TransitionCounts.html "What was observed"
page_has classsspql_1_1sim_1_1Box2dBackend.html "velocity servo"
page_has group__paths.html shortest_paths_to
page_has group__core.html SSPQL_ASSERT
page_has modules.html "Observations become states"
# Not what only the library itself calls.
page_has_not classsspql_1_1AdaptiveSspql.html add_states
page_has_not classsspql_1_1QTable.html serialize
page_has_not annotated.html detail::

# Each picture that a page shows is there, and so is each page that a page leads to.
for kind in src data href; do
    grep -oh " $kind=\"[^\"#:]*\.\(svg\|html\)" "$html"/*.html | sed 's/.*"//' | sort -u | while read -r file; do
        [ -s "$html/$file" ] || echo "$file"
    done
done >"$docs/missing.txt"
[ -s "$docs/missing.txt" ] && fail "not there: $(cat "$docs/missing.txt")"

# Text that the filters left as it was: links and headings of Markdown.
sed 's/<[^>]*>//g' "$html"/*.html | grep '@ref \|@subpage \|{#[a-z]\|](\(@\|docs\|examples\|images\|\.\.\)' && fail "the above is Markdown"
[ "$failures" -eq 0 ] && echo "$(find "$html" -name '*.html' | wc -l) pages"
exit "$failures"
