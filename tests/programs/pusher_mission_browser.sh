# SPDX-License-Identifier: MIT
# The missions' report in a real browser: it plays, pauses, scrubs, answers to keys, shows what it should, and reports no
# errors. The page tries itself out ("#selftest") and writes what it found into its own text.
set -u
program=$1/bench/pusher_mission
browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome) || {
    echo "skipped: no chromium"
    exit 77
}
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT

"$program" --missions 20 --robots 5 --threads 2 --curve-seeds 5 --html "$work/report.html" >"$work/out" || exit 1
size=$(wc -c <"$work/report.html")
echo "report of 20 missions: $size bytes"
[ "$size" -lt 5000000 ] || {
    echo "a report of 20 missions must have less than 5 MB"
    exit 1
}
# Self-contained: nothing is fetched. (Names of XML namespaces are no addresses.)
if grep -oE '(src|href)="?https?:[^" >]*|url\([^)]*|@import[^;]*|fetch\([^)]*' "$work/report.html"; then
    echo "the report refers to something outside of it"
    exit 1
fi

# browse NAME ADDRESS: the page's text after it ran, in NAME.html.
browse() {
    timeout 120 "$browser" --headless --no-sandbox --disable-gpu --disable-background-networking --no-first-run \
        --user-data-dir="$work/profile-$1" --enable-logging=stderr --run-all-compositor-stages-before-draw \
        --virtual-time-budget=60000 --dump-dom "$2" >"$work/$1.html" 2>"$work/$1.err"
}

browse page "file://$work/report.html#selftest"
[ -s "$work/page.html" ] || {
    tail -5 "$work/page.err"
    echo "skipped: the browser does not run here"
    exit 77
}
sed -n '/id="selftest"/,/<\/pre>/p' "$work/page.html"
grep -q '^SELFTEST PASSED' "$work/page.html" || {
    echo "the page's own test did not pass"
    exit 1
}
[ "$(grep -c '^ok ' "$work/page.html")" -ge 15 ] || {
    echo "the page's own test is not whole"
    exit 1
}
if grep 'CONSOLE' "$work/page.err"; then
    echo "the browser's console has messages"
    exit 1
fi

# The other way round: a page whose script is broken must not pass.
sed 's/^function render() {/function render() { nonsense();/' "$work/report.html" >"$work/broken.html"
browse broken "file://$work/broken.html#selftest"
if grep -q '^SELFTEST PASSED' "$work/broken.html"; then
    echo "a broken page passes: this test tests nothing"
    exit 1
fi
exit 0
