# SPDX-License-Identifier: MIT
# NumPy and Python's csv module read what examples/06_export wrote, and it is what the logged steps lead to: the counts
# counted again, Q learnt again by eq. 1, the policy's values Q's.
set -u
build=$1
python=/usr/bin/python3 # Debian's, which has Debian's NumPy
"$python" -c 'import numpy' 2>/dev/null || { echo "skipped: no python3-numpy"; exit 77; }
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT

"$build/examples/06_export" "$work" || exit 1
"$python" - "$work" <<'END'
import csv
import sys

import numpy as np

directory = sys.argv[1]
q = np.load(directory + "/q.npy")
counts = np.load(directory + "/counts.npy")
with open(directory + "/steps.csv", newline="") as file:
    steps = list(csv.DictReader(file))
with open(directory + "/policy.csv", newline="") as file:
    policy = list(csv.DictReader(file))

assert q.shape == (70, 4) and q.dtype == np.dtype("<f8"), (q.shape, q.dtype)
assert len(steps) > 1000, len(steps)
assert counts.dtype.names == ("s", "a", "next", "n", "weight", "terminal"), counts.dtype

again = {}
learnt = np.zeros(q.shape)
for step in steps:
    s, a, next_ = int(step["state"]), int(step["action"]), int(step["next"])
    terminal = step["terminated"] == "1"
    n, _ = again.get((s, a, next_), (0, False))
    again[s, a, next_] = (n + 1, terminal)
    future = 0.0 if terminal else learnt[next_].max()
    learnt[s, a] += 0.8 * (float(step["reward"]) + 0.8 * future - learnt[s, a])

rows = {(int(r["s"]), int(r["a"]), int(r["next"])): (int(r["n"]), bool(r["terminal"])) for r in counts}
assert rows == again, "counts differ"
assert (counts["weight"] == 1.0).all()
order = list(zip(counts["s"], counts["a"], counts["next"]))
assert order == sorted(order), "rows are in no order"
assert np.abs(q - learnt).max() < 1e-12, np.abs(q - learnt).max()

names = ["up", "down", "left", "right"]
assert len(policy) == 70
for s, row in enumerate(policy):
    assert int(row["state"]) == s
    assert int(row["visits"]) == sum(n for (s2, _, _), (n, _) in again.items() if s2 == s)
    assert float(row["value"]) == q[s, names.index(row["action"])], row
    if row["path_next"]:
        assert any((s, a, int(row["path_next"])) in again for a in range(4)), row
        assert float(row["path_distance"]) > float(policy[int(row["path_next"])]["path_distance"]), row
assert sum(row["path_next"] != "" for row in policy) > 40
print(len(steps), "steps,", len(counts), "rows of counts: all as they were logged")
END
