# SPDX-License-Identifier: MIT
# What the program does not understand, or no mission could succeed with, gives one line on stderr, nothing on stdout,
# exit 2, and leaves no file behind.
set -u
program=$1/bench/pusher_mission
. "$2/tests/programs/lib/refused.sh"

json=$work/results/out.json
html=$work/results/out.html
all="--train-episodes 2 --curve-seeds 1 --json $json --html $html"

refused --missions $all --missions 0
refused --missions $all --missions -3
refused --missions $all --missions 1.5
refused --missions $all --missions many
refused --seed $all --missions 1 --seed 0
refused --robots $all --missions 1 --robots 0
refused --noise $all --missions 1 --noise -1
refused --noise $all --missions 1 --noise nan
refused --sensing $all --missions 1 --sensing psychic
refused --box-mass $all --missions 1 --box-mass 0
refused --friction $all --missions 1 --friction -0.1
refused --threads $all --missions 1 --threads -1
refused --frobnicate $all --missions 1 --frobnicate
refused "unknown learner 'dqn'" $all --missions 1 --learner dqn
refused "one learner" $all --missions 1 --learner q,sspql

refused "the box at (2.2, 2.2) cannot be pushed" $all --missions 1 --box 2.2,2.2
refused "the box at (2.2, 2.2) cannot be pushed" $all --missions 1 --box 2.2,2.2 --goal 0,0
refused "the box at (2.45, 0) reaches into a wall" $all --missions 1 --box 2.45,0
refused "the goal at (2.6, 0) is unreachable" $all --missions 1 --goal 2.6,0
refused "the goal at (0, -3) is unreachable" $all --missions 1 --box 0,0 --goal 0,-3
refused "in the middle of the goal" $all --missions 1 --box 0.5,0 --goal 0.5,0
refused "--box must be x,y" $all --missions 1 --box 1
refused "--box must be x,y" $all --missions 1 --box 1,2,3
refused "--goal must be x,y" $all --missions 1 --goal here,there
refused "must be finite" $all --missions 1 --box nan,0

refused /nowhere/out.json --missions 1 --html "$html" --json /nowhere/out.json
refused /nowhere/out.html --missions 1 --json "$json" --html /nowhere/out.html
refused "$work/results" --missions 1 --html "$html" --json "$work/results"

refusal_keeps --missions 0 --json "$work/kept"
accepted "$json" "$html" -- $all --missions 2 --replay 1 --box 0.5,-.5 --goal -1.2,1
answers_help_and_version

[ "$failures" -eq 0 ]
