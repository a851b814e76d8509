# SPDX-License-Identifier: MIT
# links.sh SOURCE: every relative link and anchor of README.md, CONTRIBUTING.md and docs/*.md leads somewhere, and every
# page of docs/ can be reached from docs/README.md.
set -u
cd "$1" || exit 1
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT

# Lines "PAGE LINE TARGET" of the links, and "PAGE#ANCHOR" of the headings, as GitHub names them.
awk -v links="$work/links" -v anchors="$work/anchors" '
    FNR == 1 { fenced = 0 }
    /^ *```/ { fenced = !fenced; next }
    fenced { next }
    /^#+ / {
        heading = $0
        sub(/^#+ +/, "", heading)
        while (match(heading, /\]\([^)]*\)/)) heading = substr(heading, 1, RSTART - 1) substr(heading, RSTART + RLENGTH)
        heading = tolower(heading)
        gsub(/[]!"#$%&\047()*+,.\/:;<=>?@[\\^`{|}~]/, "", heading)
        gsub(/ /, "-", heading)
        again = seen[FILENAME, heading]++
        print FILENAME "#" heading (again ? "-" again : "") > anchors
    }
    {
        line = $0
        gsub(/`[^`]*`/, "", line)
        # Markdown allows it, but Doxygen stumbles over it.
        if (line ~ /^[^[]*\]\(/) print FILENAME, FNR, "(a link in two lines)" > links
        while (match(line, /\]\([^) ]+/)) {
            print FILENAME, FNR, substr(line, RSTART + 2, RLENGTH - 2) > links
            line = substr(line, RSTART + RLENGTH)
        }
    }
' README.md CONTRIBUTING.md docs/*.md || exit 1

failures=0
checked=0
complain() {
    echo "$*"
    failures=$((failures + 1))
}
: >"$work/reached"
while read -r page line target; do
    case $target in
    '(a'*) complain "$page:$line: a link's text must stand on one line"; continue ;;
    http://* | https://* | mailto:*) continue ;;
    esac
    checked=$((checked + 1))
    file=${target%%#*}
    if [ -z "$file" ]; then
        file=$page
    else
        folder=$(dirname "$page")
        [ -e "$folder/$file" ] || { complain "$page:$line: there is no $file"; continue; }
        file=$(cd "$folder" && cd "$(dirname "$file")" && pwd -P)/$(basename "$file")
        file=${file#"$(pwd -P)"/}
    fi
    echo "$page $file" >>"$work/reached"
    case $target in
    *.md#* | '#'*)
        grep -qxF "$file#${target#*#}" "$work/anchors" || complain "$page:$line: $file has no heading #${target#*#}"
        ;;
    esac
done <"$work/links"

for page in docs/*.md; do
    [ "$page" = docs/README.md ] && continue
    grep -qxF "docs/README.md $page" "$work/reached" || complain "docs/README.md does not list $page"
done
[ "$checked" -gt 0 ] || complain "no link was found"
[ "$failures" -eq 0 ]
