#pragma once
/// @file terminal.hpp
/// What a person's terminal can show. A pipe or file gets plain text.

#include <string>
#include <string_view>

namespace sr::course {

[[nodiscard]] bool stdout_is_terminal();
[[nodiscard]] bool stderr_is_terminal();

enum class Emphasis { strong, good, bad };

/// `text` in colour, for stdout; unchanged when stdout is no terminal or NO_COLOR is set
/// (https://no-color.org).
[[nodiscard]] std::string emphasise(std::string_view text, Emphasis emphasis);

/// Columns that a UTF-8 text takes on a terminal: one for each code point, which is right for what the course
/// prints.
[[nodiscard]] std::size_t width(std::string_view utf8);

}  // namespace sr::course
