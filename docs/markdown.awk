# What Doxygen reads in place of a text of the course: formulas between $ and $$ in its own brackets; pictures by
# name, since it finds those by IMAGE_PATH; links only to what the site has. Code, in fences or `ticks`, stays as
# it is.
/^ *(```|~~~)/ { in_code = !in_code; print; next }
in_code        { print; next }
{
    line = links_of_the_site(pictures_without_links(plain_captions($0)))
    gsub(/\]\((\.\.\/)*docs\/pictures\//, "](", line)
    count = split(line, part, "`")
    for (i = 1; i <= count; i++) {
        if (i % 2 || in_display) part[i] = with_formulas(part[i])
        printf "%s%s", (i > 1 ? "`" : ""), part[i]
    }
    print ""
}

# A picture's caption may hold no formula: $x$ becomes x.
function plain_captions(text,    result, caption) {
    result = ""
    while (match(text, /!\[[^\]]*\]/)) {
        caption = substr(text, RSTART, RLENGTH)
        gsub(/\$/, "", caption)
        result = result substr(text, 1, RSTART - 1) caption
        text = substr(text, RSTART + RLENGTH)
    }
    return result text
}

# [![a](b)](c) becomes ![a](b): Doxygen knows no picture in a link.
function pictures_without_links(text,    link) {
    while (match(text, /\[!\[[^][]*\]\([^)]*\)\]\([^)]*\)/)) {
        link = substr(text, RSTART + 1, RLENGTH - 1)
        text = substr(text, 1, RSTART - 1) substr(link, 1, index(link, ")")) substr(text, RSTART + RLENGTH)
    }
    return text
}

# A link to a page of the site or of the web, or to a header's documentation; of any other only its words remain.
# The site names sections as it likes, so that a link into a page becomes one to the page.
function links_of_the_site(text,    result, link, words, plain, target) {
    result = ""
    while (match(text, /\[[^][]*\]\([^)]*\)/)) {
        link = substr(text, RSTART, RLENGTH)
        words = substr(link, 2, index(link, "](") - 2)
        target = substr(link, length(words) + 4, RLENGTH - length(words) - 4)
        sub(/\.md#.*/, ".md", target)
        plain = words
        gsub(/`/, "", plain)  # Doxygen shows ticks in a link as they are
        if (target ~ /(^|\/)(tests|exercises|solutions)\//) link = words  # those are no pages
        else if (target ~ /\.hpp$/) link = "[" plain "](@ref " header(target) ")"
        else if (target ~ /:\/\/|\.md$|\.(svg|png)$/) link = "[" plain "](" target ")"
        else link = words
        result = result substr(text, 1, RSTART - 1) link
        text = substr(text, RSTART + RLENGTH)
    }
    return result text
}

# ../../common/math/frame.hpp as #include names it.
function header(path) {
    sub(/.*common\//, "", path)
    return path
}

function with_formulas(text,    result, at) {
    result = ""
    while (at = index(text, "$")) {
        result = result substr(text, 1, at - 1)
        if (substr(text, at, 2) == "$$") {
            in_display = !in_display
            result = result (in_display ? "\\f[" : "\\f]")
            text = substr(text, at + 2)
        } else {
            result = result "\\f$"
            text = substr(text, at + 1)
        }
    }
    return result text
}
