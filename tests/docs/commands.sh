# SPDX-License-Identifier: MIT
# commands.sh SOURCE BUILD: the commands that README.md, CONTRIBUTING.md and docs/*.md show can be typed. Checked are
# names, not what they do: the options, learners and maps of our programs, presets, CMake options, scripts and source files.
set -u
source=$1
build=$2
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
[ -x "$build/bench/grid_experiment" ] || { echo "SKIP: the experiment programs are not built"; exit 77; }
cd "$source" || exit 1

# Lines "PAGE:LINE<tab>COMMAND": those of sh blocks (a line that ends in a backslash goes on) and of `code` in the text.
awk '
    function tell(where, command) { # the rest of the text has nothing to be checked
        if (command ~ /--|SSPQL_|^[a-z.]+\/[^ ]*\.(cpp|sh)/) print where "\t" command
    }
    function tell_code() { # of a paragraph, whose code may go on in the next line
        while (match(paragraph, /`[^`]+`/)) {
            tell(begins, substr(paragraph, RSTART + 1, RLENGTH - 2))
            paragraph = substr(paragraph, RSTART + RLENGTH)
        }
        paragraph = ""
    }
    FNR == 1 { tell_code(); fenced = shell = 0; begun = "" }
    /^ *```/ { tell_code(); fenced = !fenced; shell = /^ *```sh/; next }
    shell && /\\$/ { begun = begun substr($0, 1, length($0) - 1); next }
    shell { tell(FILENAME ":" FNR, begun $0); begun = ""; next }
    fenced { next }
    /^ *$/ { tell_code(); next }
    /^\|/ { tell_code() }
    FILENAME ~ /CONTRIBUTING/ && /^    [a-z]/ { tell(FILENAME ":" FNR, $0); next }
    { if (paragraph == "") begins = FILENAME ":" FNR; paragraph = paragraph " " $0 }
    END { tell_code() }
' README.md CONTRIBUTING.md docs/*.md >"$work/commands" || exit 1

failures=0
checked=0
complain() {
    echo "$where: $*"
    failures=$((failures + 1))
}

help_of() { # program: prints the file that holds the words of its --help, nothing for none we know
    for folder in bench examples; do
        [ -x "$build/$folder/$1" ] || continue
        case $1 in bench_* | [0-9]*) return ;; esac  # Google Benchmark's options; examples have none
        [ -e "$work/$1.help" ] || "$build/$folder/$1" --help 2>&1 | tr -s ' \t,;:|=[]()' '\n' >"$work/$1.help"
        echo "$work/$1.help"
        return
    done
}

known() { # word help: whether the help has it as a word of its own
    grep -qxF -- "$1" "$2"
}

set -f
while IFS="$(printf '\t')" read -r where command; do
    help=
    before=
    words=$(printf '%s\n' "$command" | sed 's/ #.*//; s/[[:space:]]&&/ \&\&/g')
    for word in $words; do
        case $word in '&&' | '|' | ';') help= before=; continue ;; esac
        if [ -z "$help" ]; then
            case $word in
            -* | *=*) ;;
            *) help=$(help_of "${word##*/}") ;;
            esac
        fi
        [ -n "$help" ] && checked=$((checked + 1))
        case $before in
        --learners | --learner | --maps)
            if [ -n "$help" ]; then
                for name in $(printf '%s' "$word" | tr ',' ' '); do
                    case $name in *.txt | */* | [A-Z]* | '*' | '...' | '$'* | walls[0-9]*) continue ;; esac
                    known "${name%%:*}" "$help" || complain "$word: no '$name' in ${help##*/}"
                done
            fi
            ;;
        --preset)
            case $word in
            [a-z]*) grep -q "\"name\": \"$word\"" CMakePresets.json || complain "there is no preset $word" ;;
            esac
            ;;
        esac
        case $word in
        --*) [ -z "$help" ] || known "${word%%=*}" "$help" || complain "no option ${word%%=*} in ${help##*/}" ;;
        esac
        case $word in
        -DSSPQL_* | SSPQL_*=*)
            name=${word#-D}
            name=${name%%=*}
            checked=$((checked + 1))
            grep -rqsw --include=CMakeLists.txt --include='*.cmake' --include=CMakePresets.json --include='*.in' \
                -- "$name" CMakeLists.txt CMakePresets.json cmake src bench tests python ||
                complain "no CMake option $name"
            ;;
        examples/*.cpp | cmake/*.sh | bench/*.sh | tests/*.sh | .ci/*)
            checked=$((checked + 1))
            [ -e "$word" ] || case $word in *[A-Z*]*) ;; *) complain "there is no $word" ;; esac
            ;;
        esac
        before=$word
    done
done <"$work/commands"
[ "$checked" -gt 50 ] || { echo "only $checked commands were found"; exit 1; }
[ "$failures" -eq 0 ]
