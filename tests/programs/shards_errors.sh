# SPDX-License-Identifier: MIT
# Shards that are none, or do not belong together, give one line on stderr that names file and field, nothing on stdout,
# exit 2, and leave no file behind.
set -u
bench=$1/bench
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
mkdir results
failures=0

# refused TEXT PROGRAM ARGUMENTS...: TEXT must stand in the line.
refused() {
    text=$1
    program=$2
    shift 2
    "$bench/$program" "$@" >out 2>err
    status=$?
    problem=
    [ "$status" -eq 2 ] || problem="exit $status instead of 2"
    [ "$(wc -l <err)" -eq 1 ] || problem="$problem; not one line on stderr"
    [ ! -s out ] || problem="$problem; something on stdout"
    grep -qF -- "$text" err || problem="$problem; the line lacks '$text'"
    left=$(ls -A results)
    [ -z "$left" ] || problem="$problem; left behind: $left"
    rm -rf results
    mkdir results
    if [ -n "$problem" ]; then
        printf '%s %s: %s\n' "$program" "$*" "$problem"
        cat err
        failures=$((failures + 1))
    fi
}

short="--backend kinematic --seeds 3 --episodes 2 --learners q,sspql"
for program in pusher_experiment grid_experiment pusher_mission; do
    task=
    [ $program != grid_experiment ] || task="--maps open64"
    for shard in 0/4 5/4 x 1/0 '' 1 1/ /4 1/4/4 -1/4 +1/4 ' 1/4' 1.0/4 1/99999999999999999999 1/100001; do
        refused "--shard must be i/n with i from 1 to n" $program $task --shard "$shard" --out results/shard
    done
    refused "--shard needs --out" $program $task --shard 1/2
    refused "give --shard" $program $task --out results/shard
    refused "merge_results writes the reports" $program $task --shard 1/2 --out results/shard --json results/json
    refused "cannot write /nowhere/shard" $program $task --shard 1/2 --out /nowhere/shard
done

# shard NAME PROGRAM OPTIONS...
shard() {
    name=$1
    program=$2
    shift 2
    "$bench/$program" "$@" --out "$name" >/dev/null || {
        echo "$name could not be written"
        exit 1
    }
}
for i in 1 2 3; do shard s$i pusher_experiment $short --shard $i/3; done
shard other pusher_experiment --backend kinematic --seeds 4 --episodes 2 --learners q,sspql --shard 2/3
shard noisy pusher_experiment $short --noise 0.5 --shard 2/3
shard halves pusher_experiment $short --shard 2/2
printf 'S..G\n' >a.map
shard a1 grid_experiment --maps a.map --seeds 2 --episodes 2 --learners q --shard 1/2
printf 'S.G.\n' >a.map
shard a2 grid_experiment --maps a.map --seeds 2 --episodes 2 --learners q --shard 2/2
shard m1 pusher_mission --missions 2 --robots 2 --train-episodes 1 --curve-seeds 0 --shard 1/2

merge="refused_merge"
refused_merge() {
    text=$1
    shift
    refused "$text" merge_results "$@" --json results/report.json --html results/report.html
}
$merge "SHARD is required"
$merge "no such file: nothing" s1 nothing
$merge "missing of the run that s1 is of: shard 3/3" s1 s2
$merge "missing of the run that s2 is of: shards 1/3, 3/3" s2
$merge "s1: shard 1/3 was given before, as s1" s1 s2 s1 s3
$merge 'other: of another run than s1: settings.seeds is "4", not "3"' s1 other s3
$merge 'noisy: of another run than s1: settings.noise is "0.5", not "1"' s1 noisy s3
$merge 'halves: of another run than s1: shards is 2, not 3' s1 halves s3
$merge 'm1: of another run than s1: program is "pusher_mission", not "pusher_experiment"' s1 m1
$merge "a2: of another run than a1: phases[0].optimal_steps" a1 a2
refused "--csv: pusher_mission has no such output" merge_results m1 --csv results/report.csv
refused "--arena-svg: grid_experiment has no such output" merge_results a1 --arena-svg results/arena.svg
refused "cannot write /nowhere/report.json" merge_results s1 s2 s3 --json /nowhere/report.json --html results/report.html

: >empty
$merge "empty: the file is empty" s1 empty s3
"$bench/pusher_experiment" $short --json report.json >/dev/null
$merge "report.json: not a shard file" s1 report.json
head -c 1000 s2 >cut
$merge "cut: damaged shard file: 1000 bytes" s1 cut s3
head -c 40 s2 >stump
$merge "stump: not a shard file" s1 stump s3
{ cat s2 && echo; } >longer
$merge "longer: damaged shard file" s1 longer s3
sed 's/"steps":\[./"steps":[9/' s2 >changed
cmp -s s2 changed && sed 's/"steps":\[./"steps":[8/' s2 >changed
$merge "changed: damaged shard file: its checksum" s1 changed s3
sed '1s/"format_version":1/"format_version":2/' s2 >newer
$merge "newer: shard format 2" s1 newer s3

# A report that was there survives, and right shards are accepted in any order.
echo precious >kept.json
"$bench/merge_results" s1 s2 --json kept.json >/dev/null 2>&1
[ "$(cat kept.json)" = precious ] || {
    echo "a refused merge changed the file it should have written"
    failures=$((failures + 1))
}
"$bench/merge_results" s3 s1 s2 --json kept.json >out 2>err && [ -s out ] && [ ! -s err ] || {
    echo "good shards were refused"
    cat err
    failures=$((failures + 1))
}

[ "$failures" -eq 0 ]
