# SPDX-License-Identifier: MIT
# merge_results makes of a run's shards what one process prints and writes, digit for digit; only measured times differ.
set -u
bench=$1/bench
. "$2/tests/programs/lib/comparable.sh"
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1

quietly() {
    "$@" >log 2>err || {
        printf '%s: exit %s\n' "$*" "$?"
        cat err
        exit 1
    }
    [ ! -s err ] || {
        printf '%s: something on stderr\n' "$*"
        cat err
        exit 1
    }
}

# reports NAME: the options of the reports that the program has.
reports() {
    echo "--json $1.json --html $1.html"
    [ "$program" = pusher_mission ] || echo "--csv $1.csv"
    [ "$program" != pusher_experiment ] || echo "--arena-svg $1.arena.svg --curves-svg $1.curves.svg"
}

# merged COUNT OPTIONS...: in that many shards.
merged() {
    count=$1
    shift
    files=
    for i in $(seq "$count"); do
        # Each with another number of threads; given to merge_results last to first.
        quietly "$bench/$program" "$@" --shard "$i/$count" --out "shard$i" --threads "$i"
        files="shard$i $files"
    done
    # shellcheck disable=SC2046,SC2086
    quietly "$bench/merge_results" $files $(reports merged)
    mv log merged.txt
    comparable merged
    for part in one.*; do
        cmp "$part" "merged${part#one}" || {
            diff "$part" "merged${part#one}" | cut -c 1-200 | head -5
            echo "$program $*: $count shards and one process differ"
            exit 1
        }
    done
    rm -f merged.* shard*
}

# same PROGRAM COUNTS OPTIONS...: in one process, and in so many shards each time.
same() {
    program=$1
    counts=$2
    shift 2
    rm -f one.*
    # shellcheck disable=SC2046
    quietly "$bench/$program" "$@" $(reports one)
    mv log one.txt
    comparable one
    for n in $counts; do merged "$n" "$@"; done
}

short="--backend kinematic --seeds 5 --episodes 12"
same pusher_experiment "1 2 3 4 7" $short --learners q,ssp,sspql,adaptive --noise 0.3
same pusher_experiment 2 $short --task turn --learners q,sspql --set '*.gamma=.9'

printf 'S..#\n....\n..#G\n' >small.map
printf 's,a,next,p,reward,terminal\n0,0,1,0.7,-1,0\n0,0,0,0.3,-1,0\n1,0,2,1,5,1\n' >small.csv
same grid_experiment "1 2 3 4" --maps open64,soft54 --seeds 4 --episodes 5
same grid_experiment 2 --maps blocking-maze --seeds 3 --learners q,dyna-q
same grid_experiment 2 --maps small.map --slip 0.25 --seeds 3 --episodes 10
same grid_experiment 2 --table small.csv --seeds 3 --episodes 10

missions="--missions 9 --robots 4 --train-episodes 10 --replay 3 --curve-seeds 3"
same pusher_mission "1 2 3 4" $missions
same pusher_mission 2 $missions --learner sspql-bonus --sensing truth --box 0.5,0.5

# A shard records what a report might want; a run without a report does not, and has the same numbers.
quietly "$bench/pusher_mission" $missions --learner sspql-bonus --sensing truth --box 0.5,0.5 --json plain.json
cmp log one.txt && cmp plain.json one.json || exit 1
