# Doxygen's input filter for the pages in Markdown: gives headings the names by which links find them elsewhere
# ("## Two words" is PAGE-two-words, PAGE the file's name), and turns links between files into references, so that a
# broken one is an error. Links from docs/README.md, the table of contents, also put the pages into its order. What the
# reference does not have (a build script, the licence) loses its link and keeps its words.
function page_of(path) {
    sub(/.*\//, "", path)
    sub(/\.md$/, "", path)
    return tolower(path)
}
function slug_of(text) {
    text = tolower(text)
    gsub(/[^a-z0-9 _-]/, "", text)
    gsub(/ /, "-", text)
    return text
}
function reference(text, target,    at) {
    gsub(/`/, "", text)
    if (target ~ /^#/) return "[" text "](@ref " page "-" substr(target, 2) ")"
    if (target ~ /\.md(#.*)?$/) {
        at = index(target, "#")
        if (at) return "[" text "](@ref " page_named(substr(target, 1, at - 1)) "-" substr(target, at + 1) ")"
        if (contents) return "@subpage " page_named(target) " \"" text "\""
        return "[" text "](@ref " page_named(target) ")"
    }
    if (target ~ /examples\/.*\.cpp$/) {
        sub(/.*\//, "", target)
        return "[" text "](@ref " target ")"
    }
    if (target ~ /examples\/?$/) return "<a href=\"examples.html\">" text "</a>"
    return text
}
# docs/README.md is the page "contents", README.md the main page "readme".
function page_named(path) {
    if (path !~ /(^|\/)README\.md$/) return page_of(path)
    return path ~ /docs\// || (in_docs && path !~ /^\.\.\//) ? "contents" : "readme"
}
function with_references(rest,    done, link, at, target) {
    while (match(rest, /!?\[[^]]*\]\([^() ]*\)/)) {
        link = substr(rest, RSTART, RLENGTH)
        at = index(link, "](")
        target = substr(link, at + 2, length(link) - at - 2)
        done = done substr(rest, 1, RSTART - 1)
        rest = substr(rest, RSTART + RLENGTH)
        if (link !~ /^!/ && target ~ /[.#]|^examples/ && target !~ /^[a-z]+:/) {
            link = reference(substr(link, 2, at - 2), target)
        }
        done = done link
    }
    return done rest
}
{ line[FNR] = $0 }
END {
    in_docs = FILENAME ~ /\/docs\/[^\/]*$/
    contents = FILENAME ~ /\/docs\/README\.md$/
    page = contents ? "contents" : page_of(FILENAME)
    for (i = 1; i <= FNR; i++) {
        if (line[i] ~ /^ *```/) fenced = !fenced
        if (fenced || line[i] ~ /^    /) {
            print line[i]
        } else if (line[i] ~ /^#+ /) {
            name = line[i] ~ /^# / && !titled ? page : page "-" slug_of(substr(line[i], index(line[i], " ") + 1))
            if (line[i] ~ /^# /) titled = 1
            print line[i] " {#" name (used[name]++ ? "-" used[name] - 1 : "") "}"
        } else {
            # References need their words on one line; the lines taken are given back where the paragraph ends.
            for (text = line[i]; text ~ /\[[^]]*$/ && line[i + 1] ~ /^[^][|]*\]\(/; owed++) text = text " " line[++i]
            print with_references(text)
            if (text == "") for (; owed > 0; owed--) print ""
        }
    }
}
