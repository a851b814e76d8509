# Doxygen's input filter for headers. It keeps the numbers of lines: those in warnings are right.
# - What is in namespaces sspql and sspql::sim joins the group of its folder (groups.dox).
# - Every header has a page, also one that says nothing about itself.
# - Hidden: what is public or protected for our own templates' sake. Befriended classes, defaulted members, deduction
#   guides, what a CRTP base keeps for Derived, serialize() (core/serialization.hpp).
# - "eq. 2" and "0 .. n-1" do not end a first sentence; names of the manual's pages are links.
FNR == 1 {
    group = FILENAME
    sub(/.*\/sspql\//, "", group)
    if (!sub(/\/[^\/]*$/, "", group)) group = ""
    gsub(/\//, "_", group)
}
/^#pragma once$/ { $0 = "using namespace sspql; using namespace sspql::sim;" }
group != "" && /^namespace sspql(::sim)? \{$/ { $0 = $0 " /** \\addtogroup " group " */ /** \\{ */" }
group != "" && /^\}  \/\/ namespace sspql(::sim)?$/ { $0 = "/** \\} */ " $0 }
/^ *friend [^(]*;$/ || /= default;$/ { $0 = "" }
/^ *protected:$/ { $0 = "private:" }
/\/\/\/ (.* )?Ours: / { ours = 1 }  # at the end of what a file says of itself, where names would not be found
!/^\/\/\/ / { ours = 0 }
ours { gsub(/[A-Z][a-z0-9]+[A-Z][A-Za-z]*/, (group ~ /^sim/ ? "sspql::sim::&" : "sspql::&")) }
/\/\/\/<? [^ ]/ {
    comment = substr($0, at = index($0, "///"))
    while (match(comment, /([Ee]qs?|Figs?| \.)\. /)) {
        comment = substr(comment, 1, RSTART + RLENGTH - 2) "\\ " substr(comment, RSTART + RLENGTH)
    }
    if (match(comment, /docs\/[a-z-]+\.md/)) {
        name = substr(comment, RSTART + 5, RLENGTH - 8)
        comment = substr(comment, 1, RSTART - 1) "[docs/" name ".md](@ref " name ")" substr(comment, RSTART + RLENGTH)
    }
    # The words that tell what a sentence is about begin a line, in bold.
    if (match(comment, /^\/\/\/ (Ids|Memory|Complexity|Allocation|Errors|Threads|Chance|Deviation|Known limits?)( [a-z ]+)?:/) ||
        match(comment, /^\/\/\/ Interface, errors and threads:/)) {
        comment = (after_text ? "/// \\n **" : "/// **") substr(comment, 5, RLENGTH - 4) "**" substr(comment, RLENGTH + 1)
    }
    $0 = substr($0, 1, at - 1) comment
}
{ after_text = /^ *\/\/\/ [^ ]/ }
/\\file$/ { has_file = 1 }
/^ *template <.*>$/ {
    template = $0
    getline
    if (/^[A-Z][A-Za-z]*\(.*\) -> .*;$/) template = $0 = ""
    print (/^ *void serialize\(Archive& archive/ ? "/** \\private */" : "") template
}
{ print }
END { if (!has_file) print "/** \\file */" }
