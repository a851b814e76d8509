# SPDX-License-Identifier: MIT
# What README.md and docs/*.md quote of an example stands in it, line by line, but for indentation: the code block after
#     <!-- examples/NAME.cpp, checked by a test -->
# and what they say it prints is printed: the block after
#     <!-- printed by examples/NAME.cpp, checked by a test -->
set -u
build=$1
source=$2
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT

# A file for each block: NUMBER.code.NAME or NUMBER.print.NAME
awk -v work="$work" '
    /^<!-- (printed by )?examples\/[^ ]*\.cpp, checked by a test -->$/ {
        kind = /printed by/ ? "print" : "code"
        name = $0
        sub(/.*examples\//, "", name)
        sub(/\.cpp.*/, "", name)
        file = work "/" ++blocks "." kind "." name
        print FILENAME > (file ".page")
        next
    }
    file != "" && /^```/ { if (inside) file = ""; inside = !inside; next }
    file != "" && inside { print > file }
' "$source/README.md" "$source"/docs/*.md || exit 1

checked=0
failures=0
for page in "$work"/*.page; do
    [ -e "$page" ] || break
    block=${page%.page}
    name=${block##*.}
    if [ "${block%.print.*}" != "$block" ]; then
        whole=$work/printed
        "$build/examples/$name" >"$whole" || failures=$((failures + 1))
    else
        whole=$source/examples/$name.cpp
    fi
    checked=$((checked + 1))
    # Line ends are kept as separators, so that only whole lines match.
    awk '
        { sub(/^[ \t]+/, ""); text[FILENAME == ARGV[1]] = text[FILENAME == ARGV[1]] "\n" $0 }
        END { exit !(text[1] != "" && index(text[0] "\n", text[1] "\n")) }
    ' "$block" "$whole" && continue
    echo "$(cat "$page") quotes what $name.cpp does not have or print:"
    diff "$block" "$whole"
    failures=$((failures + 1))
done
[ "$checked" -gt 0 ] || { echo "nothing is quoted: the markers were not found"; exit 1; }
exit "$failures"
