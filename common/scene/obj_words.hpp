#pragma once
/// @file obj_words.hpp
/// The words of a statement, read without mercy: what is wrong is refused with its file and line.

#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/obj_statements.hpp"

namespace sr {

/// @throws std::runtime_error "file:line: problem", always
template <class... Values>
[[noreturn]] void refuse(const std::filesystem::path& file, int line, fmt::format_string<Values...> problem,
                         Values&&... values) {
    throw std::runtime_error(fmt::format("{}:{}: ", file.string(), line) +
                             fmt::format(problem, std::forward<Values>(values)...));
}

/// A word for an error message, which must stay one line that can be read.
[[nodiscard]] std::string in_quotes(std::string_view word);

/// A decimal number that float can hold; in every locale.
[[nodiscard]] std::optional<double> parse_number(std::string_view word);

/// The numbers after the keyword.
[[nodiscard]] std::vector<double> numbers_of(const std::filesystem::path& file, const Statement& statement);

/// The one word after `usemtl` or `newmtl`.
[[nodiscard]] std::string name_of(const std::filesystem::path& file, const Statement& statement);

}  // namespace sr
