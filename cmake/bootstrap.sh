#!/bin/sh
# SPDX-License-Identifier: MIT
# bootstrap.sh [--ci]: installs the Debian packages that building sspql needs, as root or through sudo.
# The list is debian/control's Build-Depends; --ci adds cmake/ci-packages.txt. Nothing missing: nothing done or said.
set -eu
here=$(dirname "$0")
control=$here/../debian/control
ci_packages=
case ${1-} in
'') ;;
--ci) ci_packages=$here/ci-packages.txt ;;
*)
    echo "usage: sh bootstrap.sh [--ci]" >&2
    exit 2
    ;;
esac

# One requirement a line: "package" or "package >= version". Of alternatives a | b the first that applies here; without
# those for other architectures and for build profiles, of which none is active.
requirements() { # architecture
    echo build-essential
    awk -v arch="$1" '
        /^#/ { next }
        /^[^ \t]/ {
            colon = index($0, ":")
            reading = tolower(substr($0, 1, colon - 1)) ~ /^build-depends(-arch|-indep)?$/
            if (reading) list = list "," substr($0, colon + 1)
            next
        }
        reading { list = list " " $0 }

        function architecture_applies(text,   words, n, i, positive) {
            n = split(text, words, " ")
            for (i = 1; i <= n; i++) {
                if (words[i] == "!" arch) return 0
                if (words[i] == arch || words[i] ~ /^(any|linux-any)$/) return 1
                if (words[i] !~ /^!/) positive = 1
            }
            return !positive
        }
        function profile_applies(text) { # any <...> whose terms are all negated
            while (match(text, /<[^>]*>/)) {
                if (substr(text, RSTART + 1, RLENGTH - 2) !~ /(^|[ \t])[^! \t]/) return 1
                text = substr(text, RSTART + RLENGTH)
            }
            return 0
        }
        function inside(text, open, close_) {
            text = substr(text, index(text, open) + 1)
            return substr(text, 1, index(text, close_) - 1)
        }
        END {
            n = split(list, entries, ",")
            for (i = 1; i <= n; i++) {
                m = split(entries[i], choices, "|")
                for (j = 1; j <= m; j++) {
                    choice = choices[j]
                    if (choice ~ /^[ \t]*$/) continue
                    if (choice ~ /\[/ && !architecture_applies(inside(choice, "[", "]"))) continue
                    if (choice ~ /</ && choice ~ />[ \t]*$/) {
                        profiles = choice
                        sub(/\([^)]*\)/, "", profiles)
                        if (!profile_applies(profiles)) continue
                    }
                    version = choice ~ /\(/ ? inside(choice, "(", ")") : ""
                    match(choice, /[a-z0-9][a-z0-9.+-]*/)
                    name = substr(choice, RSTART, RLENGTH)
                    if (name == "debhelper-compat") { # provided by debhelper of at least that version
                        name = "debhelper"
                        sub(/=/, ">=", version)
                    }
                    gsub(/[ \t]+/, "", version)
                    if (match(version, /^[<>=]+/))
                        version = " " substr(version, 1, RLENGTH) " " substr(version, RLENGTH + 1)
                    print name version
                    break
                }
            }
        }' "$control"
    if [ -n "$ci_packages" ]; then
        sed -e 's/#.*//' -e 's/[[:space:]]//g' -e '/^$/d' "$ci_packages"
    fi
}

for tool in dpkg dpkg-query apt-get; do
    if ! command -v $tool >/dev/null 2>&1; then
        echo "bootstrap: no $tool: this installs packages on Debian and its relatives only." >&2
        echo "bootstrap: elsewhere install these yourself, then run the cmake command alone:" \
            $(requirements none | sed 's/ .*//') >&2
        exit 1
    fi
done

required=$(requirements "$(dpkg --print-architecture)")
# "package version" of those of them that are installed. dpkg-query fails when it does not know one of them.
installed=$(dpkg-query -W -f '${db:Status-Status} ${Package} ${Version}\n' \
    $(printf '%s\n' "$required" | sed 's/ .*//') 2>/dev/null | sed -n 's/^installed //p') || :

missing=$(printf '%s\n' "$required" | while read -r name relation version; do
    found=$(printf '%s\n' "$installed" | sed -n "s/^$name //p" | head -n 1)
    if [ -z "$found" ] || { [ -n "$version" ] && ! dpkg --compare-versions "$found" "$relation" "$version"; }; then
        echo "$name"
    fi
done)
[ -n "$missing" ] || exit 0
missing=$(echo $missing)

as_root=
if [ "$(id -u)" -ne 0 ]; then
    as_root=sudo
    if ! command -v sudo >/dev/null 2>&1; then
        echo "bootstrap: neither root nor sudo here; ask root to run: apt-get install $missing" >&2
        exit 1
    fi
fi

echo "bootstrap: ${as_root:+sudo }apt-get install $missing"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
apt() {
    $as_root env DEBIAN_FRONTEND=noninteractive apt-get -qq -y -o Acquire::Retries=3 -o DPkg::Lock::Timeout=300 \
        "$@" </dev/null >>"$log" 2>&1
}
# A source of somebody else's that does not answer need not stop us: the installation tells.
apt update || :
if ! apt install --no-install-recommends $missing; then
    cat "$log" >&2
    echo "bootstrap: apt-get could not install $missing" >&2
    exit 1
fi
