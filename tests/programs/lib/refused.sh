# SPDX-License-Identifier: MIT
# For scripts that are told BUILD and set `program` before they read this: the ways programs refuse and accept. Results go
# to $work/results. At the end: [ "$failures" -eq 0 ].
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
mkdir "$work/results"
failures=0

failed() { # what is wrong
    printf '%s %s\n' "${program##*/}" "$*"
    [ ! -s "$work/err" ] || cat "$work/err"
    failures=$((failures + 1))
}

# refused TEXT ARGUMENTS...: one line on stderr that has TEXT in it, nothing on stdout, exit 2, no file left.
refused() {
    text=$1
    shift
    "$program" "$@" >"$work/out" 2>"$work/err"
    status=$?
    problem=
    [ "$status" -eq 2 ] || problem="exit $status instead of 2"
    [ "$(wc -l <"$work/err")" -eq 1 ] || problem="$problem; not one line on stderr"
    [ ! -s "$work/out" ] || problem="$problem; something on stdout"
    grep -qF -- "$text" "$work/err" || problem="$problem; the line lacks '$text'"
    left=$(ls -A "$work/results")
    [ -z "$left" ] || problem="$problem; left behind: $left"
    rm -rf "$work/results"
    mkdir "$work/results"
    [ -z "$problem" ] || failed "$*: $problem"
}

# A result that was there survives a command line that is refused.
refusal_keeps() { # arguments that are refused and write to $work/kept
    echo precious >"$work/kept"
    "$program" "$@" >/dev/null 2>&1
    [ "$(cat "$work/kept")" = precious ] || failed "$*: changed the file it should have written"
}

# accepted FILES -- ARGUMENTS...: exit 0, nothing on stderr, the files written.
accepted() {
    files=
    while [ "$1" != -- ]; do
        files="$files $1"
        shift
    done
    shift
    "$program" "$@" >"$work/out" 2>"$work/err" || failed "$*: refused"
    [ ! -s "$work/err" ] || failed "$*: something on stderr"
    for file in $files; do
        [ -s "$file" ] || failed "$*: $file was not written"
    done
}

answers_help_and_version() {
    for option in --help --version; do
        accepted -- "$option"
        [ -s "$work/out" ] || failed "$option: must answer on stdout"
    done
}
