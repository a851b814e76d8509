# SPDX-License-Identifier: MIT
# GraphViz draws what examples/06_export wrote without a word of complaint, and the picture has what was learnt: a node
# for each state of the log, an edge for each (s,s') in it, and the policy's paths marked.
set -u
build=$1
command -v dot >/dev/null || { echo "skipped: no dot (Debian package graphviz)"; exit 77; }
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
failures=0

expect() { # what, number, number expected
    [ "$2" -gt 0 ] && [ "$2" -eq "$3" ] && return
    echo "$1: $2, not $3"
    failures=$((failures + 1))
}

"$build/examples/06_export" "$work" || exit 1
dot -Tsvg graph.dot -o graph.svg 2>errors && dot -Tplain graph.dot -o graph.plain 2>>errors || failures=1
[ -s errors ] && { cat errors; failures=1; }

states=$(awk -F, 'NR > 1 { print $3; print $6 }' steps.csv | sort -u | wc -l)
edges=$(awk -F, 'NR > 1 && $3 != $6 { print $3, $6 }' steps.csv | sort -u | wc -l)
paths=$(awk -F, 'NR > 1 && $5 != "" { print $1, $5 }' policy.csv | wc -l)
expect "nodes" "$(grep -c '^node ' graph.plain)" "$states"
expect "nodes in the picture" "$(grep -c 'class="node"' graph.svg)" "$states"
expect "edges" "$(grep -c '^edge ' graph.plain)" "$edges"
expect "marked edges" "$(grep -c '^edge .*#c8452b' graph.plain)" "$paths"
expect "goals" "$(grep -c '^node .* doublecircle ' graph.plain)" 1
# Each marked edge is the policy's.
awk '/^edge .*#c8452b/ { print substr($2, 2) "," substr($3, 2) }' graph.plain | sort >marked
awk -F, 'NR > 1 && $5 != "" { print $1 "," $5 }' policy.csv | sort | diff - marked || failures=1
[ "$failures" -eq 0 ] && echo "$states nodes, $edges edges, $paths of them marked"
exit "$failures"
