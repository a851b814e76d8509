# SPDX-License-Identifier: MIT
# awk -f quoted.awk QUOTE WHOLE: whether the lines of QUOTE stand in WHOLE, together and in this order, but for
# indentation. A line `...` or `// ...` stands for any number of lines. Exit status 1 if not.
function bare(line) {
    sub(/^[ \t]+/, "", line)
    sub(/[ \t\r]+$/, "", line)
    return line
}
BEGIN { pieces = 0 }
FILENAME == ARGV[1] {
    line = bare($0)
    if (line == "..." || line == "// ...") {
        if (piece[pieces] != "") ++pieces
    } else {
        piece[pieces] = piece[pieces] "\n" line
    }
    next
}
# Line ends are kept as separators, so that only whole lines match.
/^#line / { next }
{ whole = whole "\n" bare($0) }
END {
    whole = whole "\n"
    if (piece[0] == "") exit 1
    for (i = 0; i <= pieces; ++i) {
        if (piece[i] == "") continue
        at = index(whole, piece[i] "\n")
        if (at == 0) exit 1
        whole = substr(whole, at + length(piece[i]))
    }
}
