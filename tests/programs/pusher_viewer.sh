# SPDX-License-Identifier: MIT
# The live window on a screen of its own: it shows the run that pusher_experiment makes, answers to keys that are really
# pressed, and says in one line what it cannot do.
set -u
program=$1/bench/pusher_viewer
experiment=$1/bench/pusher_experiment
[ -x "$program" ] || {
    echo "skipped: pusher_viewer was not built (SSPQL_BUILD_VIEWER)"
    exit 77
}
for tool in xvfb-run xdotool python3; do
    command -v $tool >/dev/null || {
        echo "skipped: no $tool"
        exit 77
    }
done
unset DISPLAY WAYLAND_DISPLAY
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
failures=0

fail() {
    echo "$*"
    failures=$((failures + 1))
}

# on_screen COMMAND...: with a screen of 900 x 640, which makes a window of 855 x 570.
on_screen() { xvfb-run -a -s "-screen 0 900x640x24" "$@"; }

# refused TEXT COMMAND...: one line on stderr with TEXT, nothing on stdout, exit 2.
refused() {
    text=$1
    shift
    "$@" >"$work/out" 2>"$work/err"
    status=$?
    [ "$status" -eq 2 ] || fail "$*: exit $status instead of 2"
    [ "$(wc -l <"$work/err")" -eq 1 ] || fail "$*: not one line on stderr"
    [ ! -s "$work/out" ] || fail "$*: something on stdout"
    grep -qF -- "$text" "$work/err" || {
        fail "$*: the line lacks '$text'"
        cat "$work/err"
    }
}

# ---- What cannot be done --------------------------------------------------------------------------------------------
refused "unknown learner 'dqn'" "$program" --learner dqn
refused "unknown learner 'dqn'" "$program" --learners q,dqn
refused "named twice" "$program" --learners q,q
refused "--speed must be one of 1, 2, 5" "$program" --speed 3
refused "--task must be one of" "$program" --task dance
refused "--backend must be one of" "$program" --backend gazebo
refused "--noise" "$program" --noise -1
refused "--seed" "$program" --seed -1
refused "--frames" "$program" --frames -1
refused "--episodes" "$program" --episodes 0
refused "--frobnicate" "$program" --frobnicate
refused "cannot write /nowhere/out.png" "$program" --screenshot /nowhere/out.png
refused "must end in .png" "$program" --screenshot "$work/out.jpeg"
refused "cannot read the font /nowhere/font.ttf" "$program" --font /nowhere/font.ttf
refused "DISPLAY is not set" "$program"
refused "cannot open the display ':77'" env DISPLAY=:77 "$program"
echo "no font" >"$work/no.ttf"
refused "cannot use $work/no.ttf as a font" on_screen "$program" --font "$work/no.ttf"
refused "has no OpenGL" xvfb-run -a -s "-extension GLX" "$program" --frames 1
[ -z "$(find "$work" -name '*.png*')" ] || fail "a refused command left a picture"
"$program" --help >"$work/out" 2>"$work/err" || fail "--help must not need a display"
grep -q -- --screenshot "$work/out" || fail "--help does not tell the options"

# ---- What is shown: the experiment's run, in a picture of the window's size ------------------------------------------
"$experiment" --backend kinematic --learners sspql-bonus --seeds 3 --episodes 12 --csv "$work/runs.csv" >/dev/null || exit 1
steps=$(awk -F, '$3 == 3 { n += $5 } END { print n }' "$work/runs.csv")
last=$(awk -F, '$3 == 3 && $4 == 12 { print $5 }' "$work/runs.csv")
on_screen "$program" --backend kinematic --learner sspql-bonus --seed 3 --episodes 12 --speed max --frames 40 \
    --screenshot "$work/end.png" >"$work/out" 2>"$work/err" || fail "exit $?: $(cat "$work/err")"
expected="sspql-bonus, seed 3, episode 12, step $last, $steps in all"
[ "$(cat "$work/out")" = "$expected" ] || fail "shown was '$(cat "$work/out")', the experiment made '$expected'"
[ ! -s "$work/err" ] || fail "something on stderr: $(cat "$work/err")"

# The same frames show the same picture; others another one.
for name in once again; do
    on_screen "$program" --task turn --speed 10 --frames 30 --screenshot "$work/$name.png" >/dev/null || fail "exit $?"
done
cmp -s "$work/once.png" "$work/again.png" || fail "the same run gave another picture"
if cmp -s "$work/once.png" "$work/end.png"; then fail "another run gave the same picture"; fi

cat >"$work/look.py" <<'PYTHON'
import struct, sys, zlib

data = open(sys.argv[1], "rb").read()
assert data[:8] == b"\x89PNG\r\n\x1a\n", "no PNG"
pieces, at = b"", 8
while at < len(data):
    length, kind = struct.unpack(">I4s", data[at:at + 8])
    body = data[at + 8:at + 8 + length]
    assert zlib.crc32(kind + body) == struct.unpack(">I", data[at + 8 + length:at + 12 + length])[0], "damaged"
    if kind == b"IHDR":
        width, height, depth, colours = struct.unpack(">IIBB", body[:10])
    if kind == b"IDAT":
        pieces += body
    at += 12 + length
assert (width, height, depth, colours) == (855, 570, 8, 6), (width, height, depth, colours)
raw, stride, rows, above = zlib.decompress(pieces), 4 * width, [], bytes(4 * width)
for y in range(height):
    kind, row = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
    for i in range(stride):
        left, up, corner = (row[i - 4], above[i], above[i - 4]) if i >= 4 else (0, above[i], 0)
        guess = left + up - corner
        by = [(abs(guess - v), k, v) for k, v in enumerate((left, up, corner))]
        row[i] = (row[i] + (0, left, up, (left + up) // 2, min(by)[2])[kind]) & 255
    rows.append(row)
    above = row


def colour(x, y):  # in units of the drawing, 1200 wide
    i = int(x * width / 1200) * 4
    return tuple(rows[int(y * width / 1200)][i:i + 3])


near = lambda a, b: all(abs(p - q) <= 12 for p, q in zip(a, b))
assert near(colour(3, 3), (0x15, 0x18, 0x1C)), "the ground is %s" % (colour(3, 3),)
assert near(colour(30, 60), (0x1B, 0x1F, 0x24)), "the arena's floor is %s" % (colour(30, 60),)
box = colour(358, 384)
assert near(box, (0x9A, 0x70, 0x40)) or near(box, (0xEB, 0xCB, 0x9E)), "the box is %s" % (box,)
goal = colour(690, 420)
assert goal[0] > 90 and goal[0] > 2 * goal[2], "the goal is %s" % (goal,)
seen = {bytes(row[i:i + 3]) for row in rows for i in range(0, stride, 4)}
assert len(seen) > 200, "only %d colours" % len(seen)
letters = sum(min(row[i:i + 3]) > 200 for row in rows for i in range(4 * 555, stride, 4))
assert letters > 500, "the panel has hardly any letters"
PYTHON
python3 "$work/look.py" "$work/end.png" || fail "that is not the picture of a run"

# Faster is faster: an action, or an episode's beginning, a tick.
for speed in 10 100; do
    on_screen "$program" --backend kinematic --learner q --speed $speed --frames 60 >"$work/out" || fail "exit $?"
    [ "$(cat "$work/out")" = "q, seed 1, episode 1, step $speed, $speed in all" ] || fail "a second at $speed: $(cat "$work/out")"
done

# ---- Keys -----------------------------------------------------------------------------------------------------------
cat >"$work/keys.sh" <<'KEYS'
title() { xdotool getwindowname "$window"; }
total() { title | sed -n 's/.*, \([0-9]*\) in all.*/\1/p'; }

# await WHAT COMMAND...: until it is true, for half a minute.
await() {
    what=$1
    shift
    for _ in $(seq 300); do
        "$@" && return
        sleep .1
    done
    echo "not seen: $what; the title is '$(title)'"
    exit 1
}
shows() { title | grep -q -- "$1"; }
at_least() { [ "$(total)" -ge "$1" ]; }
press() { xdotool key "$@"; }

"$1" --backend kinematic --learners q,sspql,adaptive --speed 1 --episodes 1000000 --screenshot "$2/keys.png" >"$2/keys.out" &
viewer=$!
window=$(timeout 120 xdotool search --sync --name '^pusher_viewer: ' | head -1)
timeout 60 xdotool windowfocus --sync "$window"

shows 'pusher_viewer: q, seed 1, episode 1,' || { echo "the title is '$(title)'"; exit 1; }
press Up Up Up Up Up
press plus plus plus plus plus
await "as fast as it can after ten times faster" at_least 1000
press space
await "paused" shows ', paused$'
before=$(title)
sleep 1
[ "$(title)" = "$before" ] || { echo "it goes on while paused: '$before', then '$(title)'"; exit 1; }
ticks=$(total)
press n
press n
await "two single steps" shows ', paused$'
await "a single step's action" at_least $((ticks + 1))
sleep .5
[ "$(total)" -le $((ticks + 2)) ] || { echo "more than two actions of two steps"; exit 1; }
press l
await "the next learner, from nothing" shows ': sspql, seed 1, episode 1, step 0, 0 in all, paused$'
press 3
await "the third learner" shows ': adaptive, seed 1, episode 1, step 0, 0 in all, paused$'
press r
await "the next seed" shows ': adaptive, seed 2, episode 1, step 0, 0 in all, paused$'
press h
press x
press space
await "going on" at_least 500
press space
await "paused again" shows ', paused$'
before=$(title)
press Escape
wait $viewer || { echo "exit $? after Esc"; exit 1; }
[ "pusher_viewer: $(cat "$2/keys.out"), paused" = "$before" ] || {
    echo "the last line '$(cat "$2/keys.out")' is not what the title was: '$before'"
    exit 1
}
KEYS
on_screen sh "$work/keys.sh" "$program" "$work" || fail "the keys do not do what they should"
[ -s "$work/keys.png" ] || fail "no picture of the last frame"

[ "$failures" -eq 0 ]
