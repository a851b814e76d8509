# SPDX-License-Identifier: MIT
# g++ and clang++ give the same numbers: the program is compiled again by the compiler that did not build it.
set -u
build=$1
source=$2
commands=$build/compile_commands.json
built_by=$(sed -n 's/^CMAKE_CXX_COMPILER:[A-Z]*=//p' "$build/CMakeCache.txt")
if "$built_by" --version | grep -qi clang; then
    other=g++
else
    other=clang++
fi
for tool in $other python3; do
    command -v $tool >/dev/null || {
        echo "skipped: no $tool"
        exit 77
    }
done
[ -f "$commands" ] || {
    echo "skipped: no $commands"
    exit 77
}
box2d=$(find /usr/lib /usr/local/lib -name 'libbox2d.so' -o -name 'libbox2d.a' 2>/dev/null | head -n 1)
[ -n "$box2d" ] || {
    echo "skipped: no libbox2d"
    exit 77
}
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT

# Include directories and definitions of the program in this build, a word a line.
python3 - "$commands" >"$work/flags" <<'PYTHON' || exit 1
import json, shlex, sys
for entry in json.load(open(sys.argv[1])):
    if entry["file"].endswith("/bench/pusher_experiment.cpp"):
        words = iter(entry.get("arguments") or shlex.split(entry["command"]))
        for word in words:
            if word in ("-I", "-isystem", "-D"):
                print(word, next(words), sep="\n")
            elif word.startswith(("-I", "-D", "-isystem", "-std=")):
                print(word)
        break
PYTHON
[ -s "$work/flags" ] || {
    echo "skipped: $commands does not know bench/pusher_experiment.cpp"
    exit 77
}

# What learns is optimised, what reports need not be.
cat >"$work/compile" <<'SH'
compiler=$1 work=$2 file=$3
case $file in
*/report/* | */shards/* | */ranks/*) optimise=-O0 ;;
*) optimise=-O2 ;;
esac
object=$work/$(printf '%s' "$file" | tr / _).o
tr '\n' '\0' <"$work/flags" | xargs -0 "$compiler" $optimise -DNDEBUG -ffp-contract=off -c "$file" -o "$object"
SH
# All but what only other programs need.
{
    ls "$source"/bench/pusher_experiment.cpp "$source"/bench/report/*.cpp "$source"/bench/experiment/*.cpp \
        "$source"/bench/shards/*.cpp "$source"/bench/ranks/one_rank.cpp |
        grep -v -e "report/[a-z_]*statement" -e report/adaptive_ -e report/honest_ -e report/recorded_ \
            -e report/verdict -e report/markdown -e experiment/page_program |
        tr '\n' '\0' | xargs -0 -n 1 -P 2 sh "$work/compile" "$other" "$work" &&
        "$other" "$work"/*.o "$box2d" -pthread -o "$work/pusher_experiment"
} >"$work/log" 2>&1 || {
    cat "$work/log"
    exit 1
}

results() {
    "$1" --backend kinematic --task "$2" --seeds 6 --threads 2 --learners q,q-bonus,ssp,sspql,sspql-bonus \
        --json "$work/out.json" >/dev/null || exit 1
    sed '/^  "timing": /,$d' "$work/out.json"
}
for task in approach turn; do
    results "$build/bench/pusher_experiment" $task >"$work/ours"
    results "$work/pusher_experiment" $task >"$work/others"
    [ "$(wc -l <"$work/ours")" -gt 20 ] || exit 1
    cmp "$work/ours" "$work/others" || {
        diff "$work/ours" "$work/others" | head -5
        echo "$task: the numbers of $built_by and $other differ"
        exit 1
    }
done
