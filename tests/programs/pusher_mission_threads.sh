# SPDX-License-Identifier: MIT
# The same command gives the same numbers and the same report, run after run and whatever --threads is.
set -u
program=$1/bench/pusher_mission
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT

# run NAME OPTIONS...
run() {
    name=$1
    shift
    "$program" --missions 24 --robots 6 --train-episodes 30 --replay 3 --curve-seeds 3 \
        --json "$work/$name.json" --html "$work/report.html" "$@" >"$work/$name.txt" 2>"$work/$name.err" || {
        printf 'pusher_mission %s: exit %s\n' "$*" "$?"
        cat "$work/$name.err"
        exit 1
    }
    # The command in the footer is the only part that may differ.
    grep -v '^<dt>command</dt>' "$work/report.html" >"$work/$name.html"
    [ "$(wc -l <"$work/$name.html")" -gt 100 ] || exit 1
}

same() {
    for part in json html txt; do
        cmp "$work/$1.$part" "$work/$2.$part" || {
            diff "$work/$1.$part" "$work/$2.$part" | cut -c 1-200 | head -5
            echo "$3"
            exit 1
        }
    done
}

run one --threads 1
run again --threads 1
run two --threads 2
run many --threads 5
same one again "two runs differ"
same one two "--threads 2 gives other numbers than --threads 1"
same one many "--threads 5 gives other numbers than --threads 1"

run other --threads 2 --seed 2
if cmp -s "$work/one.json" "$work/other.json"; then
    echo "another seed makes no difference: this test compares nothing"
    exit 1
fi
