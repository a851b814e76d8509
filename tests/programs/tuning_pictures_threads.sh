# SPDX-License-Identifier: MIT
# tuning_pictures: the same pictures and numbers with any number of threads; what it calls a default is one, and its numbers
# are grid_experiment's.
set -u
build=$1
source=$2
program=$build/bench/tuning_pictures
grid=$build/bench/grid_experiment
. "$source/tests/programs/lib/refused.sh"
refused 'give --out'
refused '--seeds must be a whole number from 2 to 100000' --out "$work/results" --seeds 1
refused 'none/tune-paper.svg' --out "$work/none" --seeds 2
[ "$failures" -eq 0 ] || exit 1

for threads in 1 3; do
    mkdir "$work/$threads"
    "$program" --out "$work/$threads" --seeds 3 --threads $threads >"$work/$threads/tune.txt" 2>"$work/err" || {
        failed "--threads $threads: exit $?"
        exit 1
    }
done
for file in tune.txt tune-paper.svg tune-adaptive.svg; do
    cmp "$work/1/$file" "$work/3/$file" || failed "$file differs between 1 and 3 threads"
done

# A line of ours: NAME.KEY=VALUE on open64: STEPS +- ...; of grid_experiment's table: NAME STEPS ...
steps() { # learner, options...: of 30 episodes on open64
    learner=$1
    shift
    "$grid" --maps open64 --episodes 30 --seeds 3 --learners "$learner" "$@" 2>/dev/null |
        awk -v name="$learner" '$1 == name { print $2 }'
}
checked=0
grep ' on open64: ' "$work/1/tune.txt" >"$work/lines"
while read -r set on task ours rest; do
    theirs=$(steps "${set%%.*}" --set "$set")
    awk -v ours="$ours" -v theirs="$theirs" 'BEGIN { exit !(theirs > 0 && (ours - theirs) ^ 2 <= .26) }' ||
        failed "$set $on $task $ours steps, grid_experiment counts $theirs"
    case $rest in
    *default) [ "$theirs" = "$(steps "${set%%.*}")" ] || failed "$set is not the default" ;;
    esac
    checked=$((checked + 1))
done <"$work/lines"
[ "$checked" -gt 60 ] || failed "only $checked numbers were compared"
[ "$failures" -eq 0 ]
