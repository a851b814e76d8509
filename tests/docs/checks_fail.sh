# SPDX-License-Identifier: MIT
# checks_fail.sh SOURCE: the tests of the manual fail where it is wrong, and say what.
set -u
source=$1
here=$source/tests/docs
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
failures=0
complain() {
    echo "$*"
    failures=$((failures + 1))
}

fresh() { # a manual without faults
    rm -rf "$work/root" "$work/out"
    mkdir -p "$work/root/docs" "$work/root/tests" "$work/out/programs" "$work/out/files" "$work/out/quotes"
    cp -r "$here" "$work/root/tests/docs"
    echo 'See [the manual](docs/README.md).' >"$work/root/README.md"
    echo '# Hm' >"$work/root/CONTRIBUTING.md"
    echo '[a page](page.md#its-3rd-part)' >"$work/root/docs/README.md"
    cat >"$work/root/docs/page.md" <<'PAGE'
# A page

## Its `3rd` part!

<!-- program shown, run by a test -->
```cpp
int main() {
    int x = 1;
```

<!-- program shown, run by a test -->
```cpp
    return x - 1;
}
```

<!-- part of shown, checked by a test -->
```cpp
int x = 1;
// ...
}
```

<!-- printed by shown, checked by a test -->
```text
two
...
four
```
PAGE
    printf '#!/bin/sh\nprintf "one\\ntwo\\nthree\\nfour\\n"\n' >"$work/program"
    chmod +x "$work/program"
}

check() { # runs everything on it
    awk -v "out=$work/out" -v "root=$work/root/" -f "$here/extract.awk" "$work/root/docs/page.md" &&
        sh "$here/quotes.sh" "$work/root" "$work/out" &&
        sh "$here/links.sh" "$work/root" &&
        sh "$here/run.sh" "$work/root" "$work/out" "$work/program" shown
}

fails() { # what it must say
    if check >"$work/said" 2>&1; then
        complain "accepted: $1"
    elif ! grep -qF -- "$1" "$work/said"; then
        complain "did not say: $1"
        cat "$work/said"
    fi
}

change() { # sed command
    fresh
    sed -i "$1" "$work/root/docs/page.md"
}

fresh
check || complain "a manual without faults is refused"
change '/^<!-- part of/d'
fails 'docs/page.md:17: C++ that no test compiles'
change 's/^<!-- part of shown/<!-- part of none/'
fails 'there is no none'
change 's/^int x = 1;/int x = 2;/'
fails 'docs/page.md:18 quotes what shown does not have'
change 's/^\/\/ \.\.\.$/int y;/'
fails 'docs/page.md:18 quotes what shown does not have'
change 's/^<!-- part of shown/<!-- bits of shown/'
fails 'a marker that says nothing known'
change 's/^four$/for/'
fails 'docs/page.md:25 does not say what shown prints'
change 's/^two$/four/; s/^four$/two/'
fails 'does not say what shown prints'
change '$d'
fails 'a block without an end'
change 's/3rd/4th/'
fails 'docs/README.md:1: docs/page.md has no heading #its-3rd-part'
change '1s/$/ [x](gone.md)/'
fails 'docs/page.md:1: there is no gone.md'
change '2s/$/[two\nlines](page.md)/'
fails "docs/page.md:3: a link's text must stand on one line"
fresh
echo >"$work/root/docs/lost.md"
fails 'docs/README.md does not list docs/lost.md'
change ''
printf '#!/bin/sh\nexit 3\n' >"$work/program"
fails 'shown failed'
[ "$failures" -eq 0 ]
