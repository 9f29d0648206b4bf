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
    return {std::move(name), {.measured = shortfall}, AtMost{measured, bound}};
}

Rows to_rows(const std::vector<Claim>& claims) {
    Rows rows{{"claim", "expected", "measured", "error", "tolerance", "pass"}};
    for (const Claim& claim : claims) {
        const std::string bound =
            claim.one_sided ? fmt::format(" (at most {:.4g})", claim.one_sided->bound) : "";
        rows.add({claim.name + bound, claim.value.expected, claim.value.measured, claim.error(),
                  claim.value.tolerance, claim.pass()});
    }
    return rows;
}

Rows to_table(const std::vector<Claim>& claims) {
    Rows table = to_rows(claims);
    for (std::size_t i = 0; i < claims.size(); ++i)
        if (const auto& side = claims[i].one_sided)
            table.rows[i] = {claims[i].name,  fmt::format("<= {:.4g}", side->bound), side->measured, "", "",
                             claims[i].pass()};
    return table;
}

std::string claim_text(const std::vector<Cell>& row, std::size_t column) {
    constexpr std::size_t expected = 1, measured = 2, error = 3, tolerance = 4;
    if (!row[tolerance].is_number()) return four_digits(row, column);
    if (column == expected || column == measured)
        return to_tolerance(row[column].number(), row[tolerance].number());
    if (column == error) return fmt::format("{:.2g}", row[column].number());
    return four_digits(row, column);
}

}  // namespace sr::course
