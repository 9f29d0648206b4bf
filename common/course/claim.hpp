#pragma once
/// @file claim.hpp
/// A sentence of the text as a number that the program measures.

#include <optional>
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

/// A claim of one side: measured <= bound.
struct AtMost {
    double measured = 0;
    double bound    = 0;
};

struct Claim {
    std::string           name;
    Measured              value;
    std::optional<AtMost> one_sided = {};  ///< what stands behind the shortfall in `value`

    [[nodiscard]] double error() const;  ///< |measured - expected|
    [[nodiscard]] bool   pass() const;   ///< error <= tolerance; NaN fails
};

/// measured <= bound, as a claim that the shortfall is 0.
[[nodiscard]] Claim at_most(std::string name, double measured, double bound);

/// As claims.csv keeps them: claim,expected,measured,error,tolerance,pass. One of one side records its shortfall,
/// and its name ends with the bound: "... (at most 0.01)".
[[nodiscard]] Rows to_rows(const std::vector<Claim>& claims);

/// As a person reads them, under the same headers: one of one side shows "<= 0.01" and what was measured.
[[nodiscard]] Rows to_table(const std::vector<Claim>& claims);

/// What a person reads of one cell of that table: digits down to the claim's tolerance.
[[nodiscard]] std::string claim_text(const std::vector<Cell>& row, std::size_t column);

}  // namespace sr::course
