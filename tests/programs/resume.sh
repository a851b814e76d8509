# SPDX-License-Identifier: MIT
# A robot that saves after every episode is killed at arbitrary moments, over and over: what it says at last is what one
# says that was never disturbed. And its file is nobody's else.
set -u
program=$1/examples/07_resume
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1

"$program" whole.sspql 400 >whole.txt || exit 1

kills=0
delay=1
while :; do
    "$program" killed.sspql 400 >killed.txt &
    pid=$!
    sleep "0.0$delay"
    kill -9 "$pid" 2>/dev/null && kills=$((kills + 1))
    wait "$pid" 2>/dev/null && break
    delay=$((delay % 9 + 1))
done
echo "killed $kills times"

tail -n 1 whole.txt >expected.txt
tail -n 1 killed.txt | cmp expected.txt - || {
    cat whole.txt killed.txt
    echo "the robot that was killed is not the one that was not"
    exit 1
}
cmp whole.sspql killed.sspql || exit 1
[ "$(ls -A | grep -c '^\.sspql-')" -le "$kills" ] || exit 1

# Errors are one line, and the file stays as it was.
head -c 1000 whole.sspql >cut.sspql
cp cut.sspql before.sspql
"$program" cut.sspql 400 >out.txt 2>error.txt
[ $? -eq 2 ] || { echo "a file cut short was accepted"; exit 1; }
[ "$(wc -l <error.txt)" -eq 1 ] && grep -q "^resume: checkpoint cut.sspql: is cut short in section '" error.txt || {
    cat error.txt
    exit 1
}
cmp cut.sspql before.sspql
