# SPDX-License-Identifier: MIT
# What the program does not understand gives one line on stderr, nothing on stdout, exit 2, and leaves no file behind.
set -u
program=$1/bench/pusher_experiment
. "$2/tests/programs/lib/refused.sh"

json=$work/results/out.json
html=$work/results/out.html
csv=$work/results/out.csv
all="--backend kinematic --episodes 1 --json $json --html $html --csv $csv"

refused --seeds $all --seeds 0
refused --seeds $all --seeds -3
refused --seeds $all --seeds 1.5
refused --seeds $all --seeds many
refused --seeds $all --seeds 99999999999999999999
refused --seeds $all --seeds
refused --episodes $all --seeds 1 --episodes 0
refused --threads $all --threads -1
refused --steps-per-episode $all --steps-per-episode 0
refused --noise $all --noise -1
refused --noise $all --noise nan
refused --noise $all --noise inf
refused --noise $all --noise loud
refused --backend --backend gazebo --json "$json"
refused --task $all --task dance
refused --starts $all --starts three
refused --frobnicate $all --frobnicate
refused surplus $all surplus

refused "unknown learner 'dqn'" $all --learners dqn
refused "unknown learner 'dqn'" $all --learners q,dqn
refused "unknown learner ''" $all --learners q,
refused "named twice" $all --learners q,q
refused "unknown key 'lambada'" $all --learners sspql --set sspql.lambada=1
refused "unknown key 'lambda'" $all --learners q --set q.lambda=1
refused "none of the learners" $all --learners q --set sspql.lambda=1
refused "no number" $all --learners sspql --set sspql.lambda=much
refused "no number" $all --learners sspql --set sspql.lambda=
refused "NAME.key=value" $all --learners sspql --set sspql.lambda
refused "gamma must lie in [0, 1], got 1.5" $all --learners q --set q.gamma=1.5
refused "alpha must lie in [0, 1], got 2" $all --learners q --set '*.alpha=2'
refused "got -0.1" $all --learners q --set '*.alpha=-0.1'
refused "noise" $all --learners q --set q.noise=0
refused "lambda" $all --learners sspql --set sspql.lambda=-1
refused "none of noise, epsilon-greedy, boltzmann" $all --learners q --set q.selector=luck

refused /nowhere/out.json --backend kinematic --seeds 1 --episodes 1 --json /nowhere/out.json --csv "$csv"
refused "$work/results" --backend kinematic --seeds 1 --episodes 1 --csv "$csv" --json "$work/results"
refused /nowhere/out.html --backend kinematic --seeds 1 --episodes 1 --json "$json" --html /nowhere/out.html
refused /nowhere/out.csv --backend kinematic --seeds 1 --episodes 1 --json "$json" --csv /nowhere/out.csv

refusal_keeps --backend kinematic --seeds 0 --json "$work/kept"
accepted "$json" "$html" "$csv" -- $all --seeds 1 --learners q,sspql --set '*.gamma=.9' --set sspql.lambda=1
answers_help_and_version

[ "$failures" -eq 0 ]
