/// @file obj_words.cpp

#include "scene/obj_words.hpp"

#include <charconv>
#include <span>

#include "math/finite_in_float.hpp"

namespace sr {

std::string in_quotes(std::string_view word) {
    return word.size() <= 40 ? fmt::format("'{}'", word) : fmt::format("'{}...'", word.substr(0, 37));
}

std::optional<double> parse_number(std::string_view word) {
    if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);  // from_chars knows no plus
    double value            = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size()) return {};
    if (!finite_in_float(value)) return {};  // nor nan and inf
    return value;
}

std::vector<double> numbers_of(const std::filesystem::path& file, const Statement& statement) {
    std::vector<double> values;
    for (const std::string_view word : std::span(statement.words).subspan(1)) {
        const auto value = parse_number(word);
        if (!value)
            refuse(file, statement.line,
                   "{} after {}; must be a finite number that float can hold, such as -1.5e3",
                   in_quotes(word), statement.words[0]);
        values.push_back(*value);
    }
    return values;
}

std::string name_of(const std::filesystem::path& file, const Statement& statement) {
    if (statement.words.size() != 2) {
        refuse(file, statement.line, "{} with {} words after it; must be one name without blanks",
               statement.words[0], statement.words.size() - 1);
    }
    return std::string(statement.words[1]);
}

}  // namespace sr
