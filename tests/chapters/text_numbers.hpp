#pragma once
/// @file text_numbers.hpp
/// The numbers that stand in a text, to hold them against those that its program claims.

#include <cstdlib>
#include <regex>
#include <set>
#include <string>

namespace sr::test {

/// Every number of a text, as its digits say: "61 195" is 61195 and $3\cdot10^{-5}$ is 3e-5.
inline std::set<double> numbers_of(std::string text) {
    const auto replace = [&](const char* what, const char* by) {
        text = std::regex_replace(text, std::regex(what), by);
    };
    replace("([0-9])(?: |\u00a0)(?=[0-9]{3}(?![0-9]))", "$1");
    replace("([0-9]) *\\\\cdot *10\\^\\{(-?[0-9]+)\\}", "$1e$2");
    replace("10\\^\\{?(-?[0-9]+)\\}?", "1e$1");
    const std::regex number("[0-9]+(?:\\.[0-9]+)?(?:e-?[0-9]+)?");
    std::set<double> numbers;
    for (std::sregex_iterator match(text.begin(), text.end(), number), none; match != none; ++match)
        numbers.insert(std::strtod(match->str().c_str(), nullptr));
    return numbers;
}

}  // namespace sr::test
