# SPDX-License-Identifier: MIT
# The same command prints the same numbers, run after run and whatever --threads is; only "timing" may differ.
set -u
program=$1/bench/pusher_experiment
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT

# The JSON without its last member, "timing", which stands on lines of its own.
without_timing() {
    sed '/^  "timing": /,$d' "$1"
}

# run NAME SEEDS OPTIONS...
run() {
    name=$1
    seeds=$2
    shift 2
    "$program" --backend kinematic --seeds "$seeds" --episodes 30 --learners q,ssp,sspql,sspql-bonus \
        --json "$work/$name.json" --csv "$work/$name.csv" "$@" >"$work/$name.txt" 2>"$work/$name.err" || {
        printf 'pusher_experiment %s: exit %s\n' "$*" "$?"
        cat "$work/$name.err"
        exit 1
    }
    grep -q '^  "timing": ' "$work/$name.json" || {
        echo "the JSON has no line of its own for \"timing\": this test would compare nothing"
        exit 1
    }
    without_timing "$work/$name.json" >"$work/$name.cut"
    [ "$(wc -l <"$work/$name.cut")" -gt 20 ] || {
        echo "nothing but \"timing\" in the JSON"
        exit 1
    }
}

same() {
    for part in cut csv txt; do
        cmp "$work/$1.$part" "$work/$2.$part" || {
            diff "$work/$1.$part" "$work/$2.$part" | head -5
            echo "$3"
            exit 1
        }
    done
}

for task in approach turn; do
    run one 6 --task $task --threads 1
    run again 6 --task $task --threads 1
    run two 6 --task $task --threads 2
    run many 6 --task $task --threads 5
    same one again "$task: two runs differ"
    same one two "$task: --threads 2 gives other numbers than --threads 1"
    same one many "$task: --threads 5 gives other numbers than --threads 1"
done

run other 7 --task turn --threads 1
if cmp -s "$work/one.cut" "$work/other.cut"; then
    echo "another number of seeds makes no difference: this test compares nothing"
    exit 1
fi
