# SPDX-License-Identifier: MIT
# The windy grid worlds by name: as far as the book says, and refused with what they cannot have. And the report tells why:
# each free cell of a map has lines about its moves.
set -u
program=$1/bench/grid_experiment
. "$2/tests/programs/lib/refused.sh"

few="--learners q,adaptive --seeds 2 --episodes 5"
json=$work/results/out.json
html=$work/results/out.html

for task in windy,15 windy-king,7; do
    rm -f "$json"
    accepted "$json" -- --maps "${task%,*}" $few --json "$json"
    grep -q "\"optimal_steps\": ${task#*,}\(\.0*\)\?," "$json" || failed "${task%,*}: is not ${task#*,} steps long"
done
accepted "$json" -- --maps windy-gusts,windy-king $few --json "$json"
rm -f "$json"

refused "--slip does not go with windy" --maps windy $few --json "$json" --slip 0.1
refused "windy has 70 cells and 4 actions, windy-king has 70 cells and 8 actions" --maps windy,windy-king $few --json "$json"
refused "map must be one of chain, windy, windy-king, windy-gusts, open64, " --maps windy-queen $few --json "$json"

accepted "$html" -- --maps open64 $few --html "$html"
for line in '[0-9.]+ steps to go$' 'up: .*, tried [0-9]*x, mostly to row [0-7], column [0-7], .* steps to go' 'down: .*, never tried'; do
    grep -qE "^$line" "$html" || failed "--html: no cell says '$line'"
done
[ "$failures" -eq 0 ]
