#pragma once
/// @file table.hpp

#include <functional>
#include <string>
#include <vector>

#include "course/csv.hpp"

namespace sr::course {

/// What a person reads of one cell of a row.
using CellText = std::function<std::string(const std::vector<Cell>& row, std::size_t column)>;

/// A text as it is, a whole number in full, any other with four significant digits.
[[nodiscard]] std::string four_digits(const std::vector<Cell>& row, std::size_t column);

/// The table for a person to read: columns aligned, those with numbers to the right.
[[nodiscard]] std::string to_text(const Rows& table, const CellText& shown = four_digits);

/// Prints it on stdout.
void print(const Rows& table);

}  // namespace sr::course
