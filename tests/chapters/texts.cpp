/// @file texts.cpp
/// What the texts quote, show and link to is there.

#include <doctest/doctest.h>

#include <regex>
#include <sstream>
#include <vector>

#include "run_course.hpp"
#include "text_numbers.hpp"

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

/// A block of code in a text, the file that it says it comes from, and words of the comment that it follows there.
struct Quote {
    std::string file;
    std::string marker;
    Lines       code;
};

/// The fenced blocks that follow a comment "<!-- path: marker -->".
std::vector<Quote> quotes_of(const std::string& text) {
    const std::regex   block("<!-- *([^ :]+): ([^\n]*?) *-->\\s*```[^\n]*\n([^]*?)\n```");
    std::vector<Quote> quotes;
    for (std::sregex_iterator match(text.begin(), text.end(), block), none; match != none; ++match)
        quotes.push_back({match->str(1), match->str(2), lines_of(match->str(3))});
    return quotes;
}

/// In small letters: a marker begins with one, where the comment begins a sentence.
std::string lower(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

/// Whether the source holds the lines of the quote, one after the other, close below its marker.
bool occurs(const Quote& quote, const Lines& source) {
    constexpr std::ptrdiff_t close = 4;  // the rest of the comment, and the head of a function
    if (quote.code.empty()) return false;
    auto at = source.begin();
    while (true) {
        at = std::search(at, source.end(), quote.code.begin(), quote.code.end());
        if (at == source.end()) return false;
        const auto first = at - std::min(close, at - source.begin());
        if (std::any_of(first, at, [&](const std::string& line) {
                return lower(line).find(lower(quote.marker)) != std::string::npos;
            }))
            return true;
        ++at;
    }
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

/// The figures, each a paragraph or a table, that are not followed by their caption "*Figure 1.2: ...*".
Lines uncaptioned(const std::string& text, int chapter) {
    const std::regex paragraph("[^\n]+(?:\n[^\n]+)*");
    Lines            missing;
    std::string      figure;
    int              number = 0;
    for (std::sregex_iterator match(text.begin(), text.end(), paragraph), none; match != none; ++match) {
        const std::string caption =
            "*Figure " + std::to_string(chapter) + "." + std::to_string(number) + ": ";
        if (!figure.empty() && !match->str().starts_with(caption)) missing.push_back(figure);
        const bool shown = match->str().find("docs/pictures/") != std::string::npos;
        figure           = shown ? match->str() : "";
        if (shown) ++number;
    }
    if (!figure.empty()) missing.push_back(figure);
    return missing;
}

std::vector<fs::path> chapter_texts() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(source_folder / "chapters"))
        if (fs::exists(entry.path() / "README.md")) files.push_back(entry.path() / "README.md");
    REQUIRE(!files.empty());  // what holds for all of none says nothing
    return files;
}

}  // namespace

TEST_CASE("the code that a text quotes is the code that is compiled") {
    for (const fs::path& file : chapter_texts()) {
        const std::vector<Quote> quotes = quotes_of(read_text(file));
        INFO(file.string());
        CHECK(quotes.size() >= 1);
        for (const Quote& quote : quotes) {
            INFO(quote.file << ": " << quote.marker);
            CHECK(occurs(quote, lines_of(read_text(source_folder / quote.file))));
        }
    }
}

TEST_CASE("a quote that differs is found") {
    const std::string text = "Text.\n\n<!-- common/x.hpp: a sum -->\n```cpp\nint  a = b;\n\n  a += c;\n```\n";
    const auto        quotes = quotes_of(text);
    REQUIRE(quotes.size() == 1);
    CHECK(quotes[0].file == "common/x.hpp");
    CHECK(quotes[0].marker == "a sum");
    CHECK(occurs(quotes[0], lines_of("// A sum.\n{\n    int a = b;\n    a += c;\n}\n")));
    CHECK(occurs(quotes[0], lines_of("int a = b;\na += c;\n\n\n// a sum\nint a = b;\na += c;\n")));
    CHECK_FALSE(occurs(quotes[0], lines_of("// a sum\n{\n    int a = b;\n    a -= c;\n}\n")));
    CHECK_FALSE(occurs(quotes[0], lines_of("// a sum\nint a = b;\nint d = 0;\na += c;\n")));
    CHECK_FALSE(occurs(quotes[0], lines_of("// a product\nint a = b;\na += c;\n")));
    CHECK_FALSE(occurs(quotes[0], lines_of("int a = b;\na += c;\n// a sum\n")));
    CHECK_FALSE(occurs({"", "a sum", {}}, lines_of("// a sum\nint a = b;\n")));
}

TEST_CASE("every figure of a text has a caption that shows its number") {
    for (const fs::path& file : chapter_texts()) {
        const std::string text    = read_text(file);
        const int         chapter = std::stoi(file.parent_path().filename().string());
        INFO(file.string());
        CHECK(uncaptioned(text, chapter) == Lines{});
    }
}

TEST_CASE("a figure without its number is found") {
    const std::string figure  = "![A thing](../../docs/pictures/x.svg)\n\n";
    const std::string caption = "*Figure 7.1: a thing.*\n\n";
    CHECK(uncaptioned(figure + caption + "Text.\n", 7) == Lines{});
    CHECK(uncaptioned("| a |\n|---|\n| " + figure + caption + "Text.\n", 7) == Lines{});
    CHECK(uncaptioned(figure + "Text.\n", 7).size() == 1);
    CHECK(uncaptioned(figure + caption + figure + caption, 7).size() == 1);
    CHECK(uncaptioned(figure + caption, 8).size() == 1);
}

TEST_CASE("the numbers of a text are read as a person reads them") {
    CHECK(numbers_of("of 61 195 pixels, 0.8 % at $3\\cdot10^{-5}$ to $10^7$, 10 of 256.") ==
          std::set<double>{61195, 0.8, 3e-5, 1e7, 10, 256});
}

TEST_CASE("every picture and file that a text links to exists") {
    std::vector<fs::path> files = chapter_texts();
    files.push_back(source_folder / "README.md");
    for (const fs::path& file : files)
        for (const std::string& link : links_of(read_text(file))) {
            INFO(file.string() << ": " << link);
            CHECK(fs::exists(file.parent_path() / link));
        }
}

TEST_CASE("no published picture names the data file that it was drawn from") {
    int pictures = 0;
    for (const auto& entry : fs::directory_iterator(source_folder / "docs" / "pictures")) {
        if (entry.path().extension() != ".svg") continue;
        INFO(entry.path().string());
        CHECK(read_text(entry.path()).find(".csv") == std::string::npos);
        ++pictures;
    }
    CHECK(pictures > 0);
}

TEST_CASE("links are found in prose, not in code") {
    CHECK(links_of("see [a](b/c.md#d) and ![x](../p.svg \"title\"), "
                   "`[i](j)`\n```\nf[0](k)\n```\n[w](https://w.org) [s](#s)") ==
          std::vector<std::string>{"b/c.md", "../p.svg"});
}

TEST_CASE("the site's filter translates formulas, pictures and links, and leaves code alone") {
    const ScratchFolder scratch{"texts"};
    std::ofstream(scratch.path / "text.md")
        << "a $x^2$ in `$HOME` [h](../../common/math/frame.hpp) [`f`](../../common/x.hpp) [`m`](Makefile) "
           "[l](LICENSE) [p](../02/README.md#21-a) [`t`](../../tests/near.hpp) "
           "[e](../../exercises/01-a/README.md)\n"
           "$$ E = \\pi L. \\tag{1.1} $$\n"
           "![Figure $a$](../../docs/pictures/01_a.svg) [![b](../docs/pictures/01_b.svg)](c.md)\n"
           "```sh\necho $A $B ![x](../../docs/pictures/y.svg)\n```\n";
    const Ended ended = run_shell(
        scratch.path, "awk -f '" + (source_folder / "docs" / "markdown.awk").string() + "' text.md");
    CHECK(ended.code == 0);
    CHECK(
        ended.out ==
        "a \\f$x^2\\f$ in `$HOME` [h](@ref math/frame.hpp) [f](@ref x.hpp) `m` l [p](../02/README.md) `t` e\n"
        "\\f[ E = \\pi L. \\tag{1.1} \\f]\n"
        "![Figure a](01_a.svg) ![b](01_b.svg)\n"
        "```sh\necho $A $B ![x](../../docs/pictures/y.svg)\n```\n");
}
