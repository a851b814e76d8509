# SPDX-License-Identifier: MIT
# quotes.sh SOURCE EXTRACTED: every C++ block of the manual belongs to a program, and what it quotes stands there.
# EXTRACTED is what extract.awk made of the pages.
set -u
source=$1
extracted=$2
here=$source/tests/docs
failures=0
checked=0

if [ -s "$extracted/errors" ]; then
    cat "$extracted/errors"
    failures=1
fi
while read -r kind target number where; do
    checked=$((checked + 1))
    quote=$extracted/quotes/$number
    case $kind-$target in
    print-*) # what examples and programs print, run.sh compares
        [ -e "$extracted/programs/$target.cpp" ] || [ -e "$source/examples/$target.cpp" ] && continue
        echo "$where: there is no program $target"
        failures=$((failures + 1))
        continue
        ;;
    code-*/*) whole=$source/$target ;;
    *) whole=$extracted/programs/$target.cpp ;;
    esac
    if [ ! -e "$whole" ]; then
        echo "$where: there is no $target"
        failures=$((failures + 1))
    elif ! awk -f "$here/quoted.awk" "$quote" "$whole"; then
        echo "$where quotes what $target does not have:"
        sed 's/^/    /' "$quote"
        failures=$((failures + 1))
    fi
done <"$extracted/index"
# A newcomer copies this one.
lines=$(grep -vc '^#line ' "$extracted/programs/your_environment.cpp" 2>/dev/null)
[ "${lines:-0}" -le 60 ] || { echo "docs/your-own-environment.md: $lines lines are more than 60"; failures=1; }
[ "$checked" -gt 0 ] || { echo "nothing is quoted: the markers were not found"; exit 1; }
[ "$failures" -eq 0 ]
