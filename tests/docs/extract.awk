# SPDX-License-Identifier: MIT
# awk -v out=DIR -f extract.awk PAGE...: what the pages' code blocks are, by the comment on the line above the block.
#
#     <!-- program NAME, run by a test -->              the block is a program, or the next piece of it on the same page
#     <!-- part of NAME, checked by a test -->          its lines stand together in that program, but for indentation
#     <!-- PATH/FILE, checked by a test -->             the same for a file of the repository
#     <!-- printed by NAME, checked by a test -->       the program prints this (NAME or examples/FILE.cpp)
#     <!-- file NAME, used by a test -->                a file that a user writes, such as CMakeLists.txt
#
# A line `// ...` (or `...` in what is printed) in a quotation stands for lines left out. Python is left to
# tests/python/manual_test.py, shell commands to scripts. Writes to DIR:
#     programs/NAME.cpp, files/NAME      the programs and files
#     quotes/N, index                    a quotation each; the index has lines "KIND TARGET N PAGE:LINE"
#     errors                             what is wrong with the pages, a line each; empty if nothing

function complain(where, what) { print where ": " what > errors }
function place(line) { return page ":" line }

BEGIN {
    errors = out "/errors"
    index_file = out "/index"
    printf "" > errors
    printf "" > index_file
}

FNR == 1 {
    if (fenced) complain(last_place, "a block without an end")
    fenced = 0
    marker = ""
    page = FILENAME
    if (root != "" && substr(page, 1, length(root)) == root) page = substr(page, length(root) + 1)
}
{ last_place = place(FNR) }

!fenced && /^<!-- .*, (run|checked|used) by a test -->$/ {
    if (marker != "") complain(place(FNR), "two markers, one block")
    marker = $0
    marker_line = FNR
    next
}

/^ *```/ && !fenced {
    language = $0
    sub(/^ *```/, "", language)
    fenced = 1
    target = ""
    what = marker
    sub(/^<!-- /, "", what)
    sub(/, (run|checked|used) by a test -->$/, "", what)
    name = what
    if (what ~ /\.py$/ || language == "sh") {
        target = ""
    } else if (what ~ /^program [a-z][a-z0-9_]*$/) {
        sub(/^program /, "", name)
        target = out "/programs/" name ".cpp"
        if ((name in owner) && owner[name] != page) complain(place(FNR), "program " name " is " owner[name] "'s")
        owner[name] = page
        printf "#line %d \"%s\"\n", FNR + 1, page > target
    } else if (what ~ /^file [A-Za-z0-9_.]+$/) {
        sub(/^file /, "", name)
        target = out "/files/" name
        if (("file " name) in owner) complain(place(FNR), "another file " name)
        owner["file " name] = page
    } else if (what ~ /^part of [a-z][a-z0-9_]*$/ || what ~ /^[A-Za-z0-9_.\/-]+\/[A-Za-z0-9_.-]+$/) {
        sub(/^part of /, "", name)
        target = out "/quotes/" ++quotes
        print "code", name, quotes, place(FNR) > index_file
    } else if (what ~ /^printed by [A-Za-z0-9_.\/-]+$/) {
        sub(/^printed by (examples\/)?/, "", name)
        sub(/\.cpp$/, "", name)
        target = out "/quotes/" ++quotes
        print "print", name, quotes, place(FNR) > index_file
    } else if (what != "") {
        complain(place(marker_line), "a marker that says nothing known: " marker)
    } else if (language == "cpp") {
        complain(place(FNR), "C++ that no test compiles: say above it what program it is of")
    }
    marker = ""
    next
}

/^ *```/ && fenced {
    fenced = 0
    next
}

fenced {
    if (target != "") print > target
    next
}

marker != "" {
    complain(place(marker_line), "a marker, but no block on the next line")
    marker = ""
}

END {
    if (fenced) complain(last_place, "a block without an end")
}
