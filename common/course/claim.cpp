/// @file claim.cpp

#include "course/claim.hpp"

#include <fmt/core.h>

#include <cmath>

#include "course/number.hpp"
#include "course/table.hpp"

namespace sr::course {

double Claim::error() const {
    return std::abs(value.measured - value.expected);
}

bool Claim::pass() const {
    return error() <= value.tolerance;
}

Claim at_most(std::string name, double measured, double bound) {
    // not std::max, which would turn NaN into 0
    const double shortfall = measured <= bound ? 0 : measured - bound;
    return {fmt::format("{} (at most {:.4g})", name, bound), {.measured = shortfall}};
}

Rows to_rows(const std::vector<Claim>& claims) {
    Rows rows{{"claim", "expected", "measured", "error", "tolerance", "pass"}};
    for (const Claim& claim : claims)
        rows.add({claim.name, claim.value.expected, claim.value.measured, claim.error(),
                  claim.value.tolerance, claim.pass()});
    return rows;
}

std::string claim_text(const std::vector<Cell>& row, std::size_t column) {
    constexpr std::size_t expected = 1, measured = 2, error = 3, tolerance = 4;
    if (column == expected || column == measured)
        return to_tolerance(row[column].number(), row[tolerance].number());
    if (column == error) return fmt::format("{:.2g}", row[column].number());
    return four_digits(row, column);
}

}  // namespace sr::course
