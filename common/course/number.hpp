#pragma once
/// @file number.hpp
/// How numbers are written for a person.

#include <cstdint>
#include <string>
#include <string_view>

namespace sr::course {

/// "1024", "65 280": from five digits on in groups of three, with spaces at which no line breaks.
[[nodiscard]] std::string whole(std::int64_t number);

/// "1 triangle", "65 280 triangles".
[[nodiscard]] std::string counted(std::int64_t number, std::string_view thing);

/// A value in the digits that its tolerance lets count, at least two: 1.9 is "1.90" to within 0.05. Of a whole
/// number, or where nothing is tolerated, all digits.
[[nodiscard]] std::string to_tolerance(double value, double tolerance);

}  // namespace sr::course
