# SPDX-License-Identifier: MIT
# Under mpirun the programs print and write what one process does, digit for digit, whatever the number of ranks; only
# measured times differ. An error on any rank ends all of them, with one line of ours.
set -u
bench=$1/bench
mpi=$1/tests/mpi
. "$2/tests/programs/lib/comparable.sh"
[ -x "$mpi/pusher_experiment" ] || {
    echo "skipped: no MPI (Debian package libopenmpi-dev) when this was configured"
    exit 77
}
command -v mpirun >/dev/null || {
    echo "skipped: no mpirun"
    exit 77
}
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1

# The MPI library does not free all it has when it ends.
ASAN_OPTIONS=${ASAN_OPTIONS:+$ASAN_OPTIONS:}detect_leaks=0
export ASAN_OPTIONS
if mpirun --version 2>/dev/null | grep -q 'Open MPI'; then
    # More ranks than cores, perhaps as root, perhaps in a container that forbids to read another process's memory.
    OMPI_MCA_btl_vader_single_copy_mechanism=none
    export OMPI_MCA_btl_vader_single_copy_mechanism
    on() { mpirun --allow-run-as-root --oversubscribe -n "$@"; }
else
    on() { mpirun -n "$@"; }
fi

# run NAME COMMAND...: with reports called NAME.
run() {
    name=$1
    shift
    csv="--csv $name.csv"
    case $* in *pusher_mission*) csv= ;; esac
    # shellcheck disable=SC2086
    "$@" --json "$name.json" --html "$name.html" $csv >"$name.txt" 2>err || {
        printf '%s: exit %s\n' "$*" "$?"
        cat err
        exit 1
    }
    comparable "$name"
}

# same RANKS PROGRAM OPTIONS...: as in one process, in so many ranks each time; 0: the MPI program without mpirun.
same() {
    counts=$1
    program=$2
    shift 2
    rm -f one.* many.*
    run one "$bench/$program" "$@"
    for n in $counts; do
        if [ "$n" -eq 0 ]; then
            run many "$mpi/$program" "$@"
        else
            run many on "$n" "$mpi/$program" "$@"
        fi
        for part in one.*; do
            cmp "$part" "many${part#one}" || {
                diff "$part" "many${part#one}" | cut -c 1-200 | head -5
                echo "$program $*: $n ranks and one process differ"
                exit 1
            }
        done
    done
}

short="--backend kinematic --seeds 5 --episodes 12"
same "0 1 2 4" pusher_experiment $short --learners q,ssp,sspql,adaptive
same "1 2 4" grid_experiment --maps open64,soft54 --seeds 3 --episodes 5
same "1 2 4" pusher_mission --missions 9 --robots 3 --train-episodes 10 --replay 3 --curve-seeds 3

# refused TEXT ARGUMENTS OF MPIRUN...: all ranks end, with status 2 and one line of the program's.
refused() {
    text=$1
    shift
    on "$@" >out 2>err
    status=$?
    [ "$status" -eq 2 ] && [ ! -s out ] && [ "$(grep -c '^pusher_experiment: ' err)" -eq 1 ] &&
        grep -F -- "$text" err | grep -q '^pusher_experiment: ' || {
        printf 'mpirun -n %s: exit %s, or not one line with: %s\n' "$*" "$status" "$text"
        cat out err
        exit 1
    }
}
program=$mpi/pusher_experiment
refused "--seeds must be" 4 "$program" $short --seeds 0
refused "cannot write /nowhere/out.json" 2 "$program" $short --json /nowhere/out.json
refused "got --shard 1/2 on 2 ranks" 2 "$program" $short --shard 1/2 --out shard
[ ! -e shard ] || exit 1
# One rank alone has something to complain about; then two ranks that were asked for different things.
refused "rank 1 on " 1 "$program" $short : -n 1 "$program" $short --learners dqn
refused 'rank 1: of another run than rank 0: settings.seeds is "6", not "5"' 1 "$program" $short : \
    -n 1 "$program" --backend kinematic --episodes 12 --seeds 6
on 2 "$program" --version >out && [ "$(wc -l <out)" -eq 1 ] || {
    echo "--version is answered by more than one rank"
    exit 1
}
