/// @file claim.cpp

#include "course/claim.hpp"

#include <fmt/core.h>

#include <cmath>

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

}  // namespace sr::course
