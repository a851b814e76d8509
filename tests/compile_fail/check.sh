# SPDX-License-Identifier: MIT
# check.sh FILE.cpp COMPILER [FLAGS...]
# NAME_ok.cpp must compile. Any other file must not: the compiler must give exactly one error, whose line contains the
# text that the file's first line announces: `// expect: TEXT`.
set -u
file=$1
shift
output=$(LC_ALL=C "$@" -fsyntax-only "$file" 2>&1)
status=$?

fail() {
    printf '%s: %s\n%s\n' "$file" "$1" "$output"
    exit 1
}

case $file in
*_ok.cpp)
    [ "$status" -eq 0 ] || fail "must compile, but does not"
    exit 0
    ;;
esac

expected=$(sed -n '1s|^// expect: *||p' "$file")
[ -n "$expected" ] || fail "its first line must be '// expect: TEXT'"
[ "$status" -ne 0 ] || fail "must not compile, but does"
errors=$(printf '%s\n' "$output" | grep 'error:')
count=$(printf '%s\n' "$errors" | grep -c .)
[ "$count" -eq 1 ] || fail "must give one error, but gives $count"
printf '%s\n' "$errors" | grep -qF -- "$expected" || fail "the error must contain '$expected'"
