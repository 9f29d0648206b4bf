/// @file texts.cpp
/// What the texts quote, show and link to is there.

#include <doctest/doctest.h>

#include <regex>
#include <sstream>
#include <vector>

#include "run_course.hpp"

using namespace sr::test;

namespace {

using Lines = std::vector<std::string>;

/// A text's lines without what does not matter in code: blank lines, and the width of white space.
Lines lines_of(const std::string& text) {
    std::istringstream stream(text);
    Lines              lines;
    for (std::string line; std::getline(stream, line);) {
        std::istringstream words(line);
        std::string        plain;
        for (std::string word; words >> word;) plain += (plain.empty() ? "" : " ") + word;
        if (!plain.empty()) lines.push_back(plain);
    }
    return lines;
}

/// A block of code in a text, and the file that it says it comes from.
struct Quote {
    std::string file;
    Lines       code;
};

/// The fenced blocks that follow a comment "<!-- path: marker -->".
std::vector<Quote> quotes_of(const std::string& text) {
    const std::regex   block("<!-- *([^ :]+): [^\n]*-->\\s*```[^\n]*\n([^]*?)\n```");
    std::vector<Quote> quotes;
    for (std::sregex_iterator match(text.begin(), text.end(), block), none; match != none; ++match)
        quotes.push_back({match->str(1), lines_of(match->str(2))});
    return quotes;
}

/// Whether the source holds the lines of the quote, one after the other.
bool occurs(const Lines& quote, const Lines& source) {
    return !quote.empty() &&
           std::search(source.begin(), source.end(), quote.begin(), quote.end()) != source.end();
}

/// The local files that a text links to or shows; code and anchors left out.
std::vector<std::string> links_of(const std::string& text) {
    const std::string        prose = std::regex_replace(text, std::regex("```[^]*?```|`[^`\n]*`"), "");
    const std::regex         link("\\]\\(([^)#\\s]+)[^)]*\\)");
    std::vector<std::string> links;
    for (std::sregex_iterator match(prose.begin(), prose.end(), link), none; match != none; ++match)
        if (match->str(1).find("://") == std::string::npos) links.push_back(match->str(1));
    return links;
}

std::vector<fs::path> chapter_texts() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(source_folder / "chapters"))
        if (fs::exists(entry.path() / "README.md")) files.push_back(entry.path() / "README.md");
    return files;
}

}  // namespace

TEST_CASE("the code that a text quotes is the code that is compiled") {
    for (const fs::path& file : chapter_texts()) {
        const std::vector<Quote> quotes = quotes_of(read_text(file));
        INFO(file.string());
        CHECK(quotes.size() >= 1);
        for (const Quote& quote : quotes) {
            INFO(quote.file << ": " << quote.code.front());
            CHECK(occurs(quote.code, lines_of(read_text(source_folder / quote.file))));
        }
    }
}

TEST_CASE("a quote that differs is found") {
    const std::string text = "Text.\n\n<!-- common/x.hpp: a sum -->\n```cpp\nint  a = b;\n\n  a += c;\n```\n";
    const auto        quotes = quotes_of(text);
    REQUIRE(quotes.size() == 1);
    CHECK(quotes[0].file == "common/x.hpp");
    CHECK(occurs(quotes[0].code, lines_of("{\n    int a = b;\n    a += c;\n}\n")));
    CHECK_FALSE(occurs(quotes[0].code, lines_of("{\n    int a = b;\n    a -= c;\n}\n")));
    CHECK_FALSE(occurs(quotes[0].code, lines_of("int a = b;\nint d = 0;\na += c;\n")));
    CHECK_FALSE(occurs({}, lines_of("int a = b;\n")));
}

TEST_CASE("every picture and file that a text links to exists") {
    std::vector<fs::path> files = chapter_texts();
    if (fs::exists(source_folder / "README.md")) files.push_back(source_folder / "README.md");
    for (const fs::path& file : files)
        for (const std::string& link : links_of(read_text(file))) {
            INFO(file.string() << ": " << link);
            CHECK(fs::exists(file.parent_path() / link));
        }
}

TEST_CASE("links are found in prose, not in code") {
    CHECK(links_of("see [a](b/c.md#d) and ![x](../p.svg \"title\"), "
                   "`[i](j)`\n```\nf[0](k)\n```\n[w](https://w.org) [s](#s)") ==
          std::vector<std::string>{"b/c.md", "../p.svg"});
}

TEST_CASE("the site's filter translates formulas, pictures and links, and leaves code alone") {
    const Scratch scratch;
    std::ofstream(scratch.path / "text.md")
        << "a $x^2$ in `$HOME` [h](../../common/math/frame.hpp) [l](LICENSE) [p](../02/README.md#21-a)\n"
           "$$ E = \\pi L. \\tag{1.1} $$\n"
           "![Figure $a$](../../docs/pictures/01_a.svg) [![b](../docs/pictures/01_b.svg)](c.md)\n"
           "```sh\necho $A $B ![x](../../docs/pictures/y.svg)\n```\n";
    const Ended ended = run_shell(
        scratch.path, "awk -f '" + (source_folder / "docs" / "markdown.awk").string() + "' text.md");
    CHECK(ended.code == 0);
    CHECK(ended.out ==
          "a \\f$x^2\\f$ in `$HOME` [h](@ref math/frame.hpp) l [p](../02/README.md)\n"
          "\\f[ E = \\pi L. \\tag{1.1} \\f]\n"
          "![Figure a](01_a.svg) ![b](01_b.svg)\n"
          "```sh\necho $A $B ![x](../../docs/pictures/y.svg)\n```\n");
}
