#pragma once
/// @file table.hpp

#include <string>
#include <vector>

#include "course/csv.hpp"

namespace sr::course {

/// The table for a person to read: columns aligned, numbers to the right with `digits` significant digits.
[[nodiscard]] std::string to_text(const Rows& table, int digits = 4);

/// Prints it on stdout.
void print(const Rows& table, int digits = 4);

}  // namespace sr::course
