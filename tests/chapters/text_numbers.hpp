#pragma once
/// @file text_numbers.hpp
/// The numbers that stand in a chapter's text, to hold them against those that its program claims.

#include <cmath>
#include <cstdlib>
#include <map>
#include <regex>
#include <set>
#include <string>

namespace sr::test {

inline std::string replaced(const std::string& text, const char* what, const char* by) {
    return std::regex_replace(text, std::regex(what), by);
}

/// Every number of a text, as its digits say: "61 195" is 61195 and $3\cdot10^{-5}$ is 3e-5.
inline std::set<double> numbers_of(std::string text) {
    text = replaced(text, "([0-9])(?: |\u00a0)(?=[0-9]{3}(?![0-9]))", "$1");
    text = replaced(text, "([0-9]) *\\\\cdot *10\\^\\{?(-?[0-9]+)\\}?", "$1e$2");
    text = replaced(text, "10\\^\\{?(-?[0-9]+)\\}?", "1e$1");
    const std::regex number("[0-9]+(?:\\.[0-9]+)?(?:e[-+]?[0-9]+)?");
    std::set<double> numbers;
    for (std::sregex_iterator match(text.begin(), text.end(), number), none; match != none; ++match)
        numbers.insert(std::strtod(match->str().c_str(), nullptr));
    return numbers;
}

/// The text's sections "## 1.4 ..." by their number.
inline std::map<std::string, std::string> sections_of(const std::string& text) {
    std::map<std::string, std::string> sections;
    const std::regex                   heading("\n## ([0-9]+\\.[0-9]+)([^\n]*)");
    for (std::sregex_iterator at(text.begin(), text.end(), heading), none; at != none; ++at) {
        const auto from      = std::size_t(at->position() + at->length());
        sections[at->str(1)] = text.substr(from, text.find("\n## ", from) - from);
    }
    return sections;
}

/// The numbers of a section that are results, by their look: with a decimal point, or of five digits and more,
/// or a power of ten; and no equation's, section's or figure's number.
inline std::set<double> results_in(std::string section) {
    section = replaced(section, "```[^`]*```|<!--[^>]*-->|\\]\\([^)]*\\)", "");
    section = replaced(section,
                       "\\\\tag\\{[^}]*\\}|\\([0-9]+\\.[0-9]+\\)|([Ff]igure|[Ss]ection) [0-9]+\\.[0-9]+", "");
    std::set<double> results;
    for (const double number : numbers_of(section)) {
        if (number != std::floor(number) || number >= 1e4) results.insert(number);
    }
    return results;
}

}  // namespace sr::test
