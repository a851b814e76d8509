# SPDX-License-Identifier: MIT
# The commands of docs/scale-out.md do what the page says: its two ways to cut a run into shards are carried out, with
# fewer and shorter seeds, and merged into what one process prints.
set -u
bench=$1/bench
page=$2/docs/scale-out.md
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
PATH=$bench:$PATH
export PATH

# block NAME: the code after the marker of that name, made short.
block() {
    awk -v marker="<!-- $1, run by a test -->" '
        $0 == marker { found = 1; next }
        found && /^```/ { if (inside) exit; inside = 1; next }
        inside { print }
    ' "$page" | sed 's/--seeds [0-9]*/--seeds 3 --episodes 4/' >"$1"
    grep -q -e '--shard' "$1" || {
        echo "$page has no block $1 with shards"
        exit 1
    }
}

pusher_experiment --seeds 3 --episodes 4 --csv one.csv >one.txt || exit 1

# The block prints a line for each shard, and then the table.
block by_hand
sh -e by_hand >by_hand.txt || exit 1
cmp one.csv episodes.csv && [ -s report.html ] && [ -s report.json ] || exit 1
tail -n "$(wc -l <one.txt)" by_hand.txt | cmp - one.txt || exit 1
rm shard-*.json

block job.sh
tasks=$(sed -n 's/^#SBATCH --array=1-//p' job.sh)
[ "$tasks" -ge 2 ] || exit 1
for i in $(seq "$tasks"); do
    SLURM_ARRAY_TASK_ID=$i SLURM_CPUS_PER_TASK=2 sh -e job.sh >/dev/null || exit 1
done
merge_results shard-*.json --csv merged.csv >merged.txt || exit 1
cmp one.csv merged.csv && cmp one.txt merged.txt
