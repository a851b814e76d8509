#!/bin/sh
# SPDX-License-Identifier: MIT
# record_adaptive.sh BUILD OUT [SEEDS]: runs what docs/adaptive-results.md and the pictures of docs/adaptive.md are made
# from and writes them to OUT, with the recorded JSON beside them: copy the page to docs/ and the pictures to
# docs/images/. BUILD is a build tree (build/release). Two to three minutes on two cores with 200 seeds.
set -euf
build=$(cd "$1" && pwd)
out=$2
seeds=${3:-200}
mkdir -p "$out"
out=$(cd "$out" && pwd)

others=q-bonus,sspql-bonus,ps-bonus,ps-optimistic,dyna-q-bonus:20
all=$others,adaptive
files=
grid() { # name options...
    name=$1
    shift
    echo "== $name"
    "$build/bench/grid_experiment" "$@" --json "$out/$name.json"
    files="$files $name.json"
}
pusher() { # name options...
    name=$1
    shift
    echo "== $name"
    "$build/bench/pusher_experiment" --learners "$all" "$@" --json "$out/$name.json"
    files="$files $name.json"
}

for slip in .1 .3; do
    for kind in soft nest; do
        grid "$kind-slip$slip" --maps "open64,${kind}54,${kind}47" --learners "$all" --slip "$slip" --seeds "$seeds"
    done
done
grid chain --maps chain --learners "$all" --slip .7 --seeds "$seeds"
grid dyna-maze --maps dyna-maze --learners "$all" --seeds "$seeds"
grid blocking-maze --maps blocking-maze --learners "$all" --seeds "$seeds"
grid shortcut-maze --maps shortcut-maze --learners "$all" --seeds "$seeds"
grid shortcut-maze-tau --maps shortcut-maze --learners adaptive --set adaptive.tau=100 --seeds "$seeds"
grid cliff --maps cliff --learners "$all" --episodes 300 --seeds "$seeds"

# Many maps say more than many seeds of one. The others get a second chance, with parameters that suit large maps.
maps=$((seeds < 10 ? 2 : seeds / 5))
long="--episodes 100 --steps-per-episode 200000 --seeds 1"
for size in 30 60; do
    map=1
    while [ "$map" -le "$maps" ]; do
        walls=walls$size$([ "$map" -eq 1 ] || echo ":$map")
        # shellcheck disable=SC2086
        grid "walls$size-$map" --maps "$walls" --learners "$all" $long
        # shellcheck disable=SC2086
        grid "walls$size-$map-tuned" --maps "$walls" --learners sspql-bonus,ps-bonus,dyna-q-bonus:20 $long \
            --set sspql-bonus.decay=1 --set sspql-bonus.gamma=.95 --set ps-bonus.gamma=.99 --set dyna-q-bonus:20.gamma=.95
        map=$((map + 1))
    done
done

pusher pusher-kinematic --backend kinematic --seeds "$seeds"
pusher pusher-turn --backend kinematic --task turn --seeds "$seeds"
pusher pusher-box2d --backend box2d --seeds $((seeds < 60 ? seeds : 60))

cd "$out"
# shellcheck disable=SC2086
"$build/bench/adaptive_results" --out adaptive-results.md $files
"$build/bench/adaptive_pictures" --out .
echo "The page: $out/adaptive-results.md, the pictures: $out/adaptive-*.svg"
