#!/bin/sh
# SPDX-License-Identifier: MIT
# record_comparison.sh BUILD OUT [SEEDS]: runs what docs/honest-comparison.md is made from and writes it to OUT, with the
# recorded JSON beside it. BUILD is a build tree (build/release). About five minutes on two cores with 200 seeds.
set -eu
build=$(cd "$1" && pwd)
out=$2
seeds=${3:-200}
mkdir -p "$out"

all=q,q-bonus,q-optimistic,sarsa,dyna-q,dyna-q-bonus,dyna-q-bonus:50,ps,ps-bonus,ps-optimistic,rtdp,rmax,ssp,sspql,sspql-bonus,sspql-constant
grid() { # name maps learners options...
    name=$1 maps=$2 learners=$3
    shift 3
    echo "== $name"
    "$build/bench/grid_experiment" --maps "$maps" --learners "$learners" --seeds "$seeds" "$@" \
        --json "$out/$name.json" --html "$out/$name.html"
}
pusher() { # name learners options...
    name=$1 learners=$2
    shift 2
    echo "== $name"
    "$build/bench/pusher_experiment" --learners "$learners" --seeds "$seeds" "$@" \
        --json "$out/$name.json" --html "$out/$name.html"
}

grid soft open64,soft54,soft47 $all
grid nest open64,nest54,nest47 $all
grid chain chain q,dyna-q:5,dyna-q-last:5,dyna-q:50,dyna-q-bonus,ps,ps-bonus,ps-optimistic,sspql,sspql-bonus,sspql-constant --slip .7
# Sutton and Barto's settings: discount .95, learning rate .1 (1 where the world changes), one action in ten at random.
book="--set *.gamma=.95 --set *.selector=epsilon-greedy --set *.epsilon=.1"
set -f
grid dyna-maze dyna-maze q,dyna-q:5,dyna-q:50,ps,ps-optimistic,sspql,sspql-bonus,sspql-constant $book --set '*.alpha=.1'
grid blocking-maze blocking-maze q,dyna-q-last:10,dyna-q-plus:10,ps,ps-optimistic,sspql,sspql-bonus,sspql-constant $book --set '*.alpha=1'
grid shortcut-maze shortcut-maze q,dyna-q-last:10,dyna-q-plus:10,ps,ps-optimistic,sspql,sspql-bonus,sspql-constant $book --set '*.alpha=1'

robot=q,q-bonus,q-optimistic,ssp,sspql,sspql-bonus,sspql-constant,dyna-q-bonus:5,dyna-q-bonus:20,dyna-q-bonus:50,ps,ps-bonus,ps-optimistic
pusher pusher-kinematic $robot --backend kinematic
pusher pusher-turn $robot --backend kinematic --task turn

cd "$out"
"$build/bench/honest_comparison" --out honest-comparison.md soft.json nest.json chain.json dyna-maze.json \
    blocking-maze.json shortcut-maze.json pusher-kinematic.json pusher-turn.json
echo "The page: $out/honest-comparison.md"
