#pragma once
/// @file claim.hpp
/// A sentence of the text as a number that the program measures.

#include <string>
#include <vector>

#include "course/csv.hpp"

namespace sr::course {

/// What a claim expects, what was measured, and how far apart they may lie (absolute).
struct Measured {
    double expected  = 0;
    double measured  = 0;
    double tolerance = 0;
};

struct Claim {
    std::string name;
    Measured    value;

    [[nodiscard]] double error() const;  ///< |measured - expected|
    [[nodiscard]] bool   pass() const;   ///< error <= tolerance; NaN fails
};

/// measured <= bound, as a claim that the shortfall is 0; its name ends with the bound: "... (at most 0.01)".
[[nodiscard]] Claim at_most(std::string name, double measured, double bound);

/// claim,expected,measured,error,tolerance,pass
[[nodiscard]] Rows to_rows(const std::vector<Claim>& claims);

/// What a person reads of one cell of these rows: digits down to the claim's tolerance.
[[nodiscard]] std::string claim_text(const std::vector<Cell>& row, std::size_t column);

}  // namespace sr::course
