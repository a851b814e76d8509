# SPDX-License-Identifier: MIT
# run.sh SOURCE EXTRACTED PROGRAM NAME: runs a program of the manual in an empty folder, as a reader would, and compares
# what it prints with what the pages say it prints.
set -u
source=$1
extracted=$2
program=$3
name=$4
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
mkdir "$work/run"
(cd "$work/run" && "$program") >"$work/printed" || {
    echo "$name failed, having printed:"
    cat "$work/printed"
    exit 1
}

failures=0
while read -r kind target number where; do
    [ "$kind $target" = "print $name" ] || continue
    awk -f "$source/tests/docs/quoted.awk" "$extracted/quotes/$number" "$work/printed" && continue
    echo "$where does not say what $name prints:"
    diff "$extracted/quotes/$number" "$work/printed"
    failures=$((failures + 1))
done <"$extracted/index"
[ "$failures" -eq 0 ]
