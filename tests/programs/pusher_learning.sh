# SPDX-License-Identifier: MIT
# What the paper claims, on the kinematic pusher: SSPQL needs half of Q-learning's steps, the bonus helps, the shortest
# path alone does less. And why w_SSP fades: with a constant weight most robots run against the box for ever.
set -u
program=$1/bench/pusher_experiment
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
seeds=20
episodes=30
"$program" --backend kinematic --task approach --seeds $seeds --episodes $episodes --threads 2 \
    --learners q,ssp,sspql,sspql-bonus,sspql-constant --json "$work/out.json" >/dev/null || exit 1

# A line for each learner: name, mean of first30_steps, capped episodes. Every member has a line of its own.
awk '
    /"name": / && /"/ { split($0, part, "\""); name = part[4] }
    /"first30_steps": \{/ && !(name in steps) {
        split($0, part, /"mean":/)
        steps[name] = part[2] + 0
    }
    /"capped_episodes": / { sub(/.*: /, ""); print name, steps[name], $0 + 0 }
' "$work/out.json" >"$work/table"
[ "$(wc -l <"$work/table")" -eq 5 ] || {
    echo "five learners expected in the JSON, read:"
    cat "$work/table"
    exit 1
}

awk -v episodes=$((seeds * episodes)) '
    { steps[$1] = $2; capped[$1] = $3 / episodes }
    function claim(what, value, holds) {
        printf "%s %-52s %.3f\n", holds ? "ok  " : "FAIL", what, value
        if (!holds) failed = 1
    }
    END {
        r = steps["sspql"] / steps["q"];       claim("SSPQL / Q-learning, steps: <= 0.55", r, r <= 0.55)
        r = steps["sspql-bonus"] / steps["q"]; claim("SSPQL with bonus / Q-learning: <= 0.45", r, r <= 0.45)
        r = steps["ssp"] / steps["q"];         claim("SSP / Q-learning: <= 0.70", r, r <= 0.70)
        r = capped["sspql-constant"];          claim("constant w_SSP, episodes that never end: >= 0.10", r, r >= 0.10)
        r = capped["sspql"];                   claim("SSPQL, episodes that never end: <= 0.01", r, r <= 0.01)
        r = capped["sspql-bonus"];             claim("SSPQL with bonus: <= 0.01", r, r <= 0.01)
        exit failed
    }
' "$work/table"
