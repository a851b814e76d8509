# SPDX-License-Identifier: MIT
# How many boxes come to the goal: with sensors that err, with twice their errors, with true poses, with other boxes.
# The bounds are those the mission must meet; 200 missions a case.
set -u
program=$1/bench/pusher_mission
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
failures=0

# value KEY: a number of the JSON's first level.
value() {
    sed -n 's/^  "'"$1"'": \([0-9.]*\),*$/\1/p' "$work/out.json"
}

# case_of IN_GOAL FIRST_PUSH OPTIONS...: least shares of boxes in the goal, and in it at the first push.
case_of() {
    least=$1
    first=$2
    shift 2
    "$program" --missions 200 --robots 20 --threads 2 --json "$work/out.json" "$@" >"$work/out" || {
        echo "pusher_mission $*: failed"
        failures=$((failures + 1))
        return
    }
    printf 'in the goal %s (>= %s), at the first push %s (>= %s): %s\n' "$(value in_goal_rate)" "$least" \
        "$(value first_push_rate)" "$first" "${*:-nominal}"
    awk -v a="$(value in_goal_rate)" -v b="$(value first_push_rate)" -v least="$least" -v first="$first" \
        'BEGIN { exit !(a != "" && b != "" && a + 0 >= least && b + 0 >= first) }' || {
        cat "$work/out"
        failures=$((failures + 1))
    }
}

case_of .94 .82
case_of .90 .60 --noise 2
case_of .98 .95 --sensing truth
case_of .93 .80 --box-mass 1
case_of .93 .80 --box-mass 4
case_of .93 .80 --friction .3
case_of .93 .80 --friction .8
case_of .94 .80 --learner sspql-bonus

[ "$failures" -eq 0 ]
