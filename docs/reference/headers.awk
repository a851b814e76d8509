# Doxygen's input filter for headers. Puts what a header has in namespaces sspql and sspql::sim into the group of its
# folder (groups.dox), so that the headers need not say it. Hides what is public or protected for our own templates'
# sake: befriended classes, defaulted members, deduction guides, what a CRTP base keeps for Derived, and serialize()
# (core/serialization.hpp).
# Gives a header a page even if it says nothing about itself, keeps "eq. 2" and "0 .. n-1" from ending a first sentence, and
# makes links of the manual's pages. Keeps the numbers of lines: those in warnings are right.
FNR == 1 {
    group = FILENAME
    sub(/.*\/sspql\//, "", group)
    if (!sub(/\/[^\/]*$/, "", group)) group = ""
    gsub(/\//, "_", group)
}
group != "" && /^namespace sspql(::sim)? \{$/ { $0 = $0 " /** \\addtogroup " group " */ /** \\{ */" }
group != "" && /^\}  \/\/ namespace sspql(::sim)?$/ { $0 = "/** \\} */ " $0 }
/^ *friend [^(]*;$/ || /= default;$/ { $0 = "" }
/^ *protected:$/ { $0 = "private:" }
/\/\/\/<? [^ ]/ {
    comment = substr($0, at = index($0, "///"))
    gsub(/eq\. /, "eq.\\\\ ", comment)
    gsub(/eqs\. /, "eqs.\\\\ ", comment)
    gsub(/Fig\. /, "Fig.\\\\ ", comment)
    gsub(/ \.\. /, " ..\\\\ ", comment)
    if (match(comment, /docs\/[a-z-]+\.md/)) {
        name = substr(comment, RSTART + 5, RLENGTH - 8)
        comment = substr(comment, 1, RSTART - 1) "[docs/" name ".md](@ref " name ")" substr(comment, RSTART + RLENGTH)
    }
    $0 = substr($0, 1, at - 1) comment
}
/\\file$/ { has_file = 1 }
/^ *template <.*>$/ {
    template = $0
    getline
    if (/^[A-Z][A-Za-z]*\(.*\) -> .*;$/) template = $0 = ""
    print (/^ *void serialize\(Archive& archive/ ? "/** \\private */" : "") template
}
{ print }
END { if (!has_file) print "/** \\file */" }
