/// @file tests.cpp

#include "statistics/tests.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace sr {
namespace {

struct Cell {
    double expected = 0;
    double observed = 0;
};

/// The cells by growing expectation.
std::vector<Cell> sorted_cells(std::span<const std::uint64_t> observed, std::span<const double> expected) {
    if (observed.size() != expected.size()) {
        throw std::invalid_argument("chi-square test of " + std::to_string(observed.size()) +
                                    " observed and " + std::to_string(expected.size()) +
                                    " expected counts; must be as many");
    }
    std::vector<Cell> cells;
    Cell              sum;
    for (std::size_t i = 0; i < observed.size(); ++i) {
        cells.push_back({expected[i], double(observed[i])});
        sum.expected += cells.back().expected;
        sum.observed += cells.back().observed;
        if (!(expected[i] >= 0)) {
            throw std::invalid_argument("chi-square test: cell " + std::to_string(i) + " expects " +
                                        std::to_string(expected[i]) + "; must be 0 or more");
        }
    }
    if (!(std::abs(sum.expected - sum.observed) <= 1e-3 * sum.observed)) {
        throw std::invalid_argument("chi-square test: " + std::to_string(sum.expected) +
                                    " expected in all, " + std::to_string(sum.observed) +
                                    " observed; must be the same");
    }
    std::sort(cells.begin(), cells.end(), [](Cell a, Cell b) { return a.expected < b.expected; });
    return cells;
}

/// Those that expect too little as one.
std::vector<Cell> pooled(const std::vector<Cell>& sorted) {
    std::vector<Cell> cells{{}};
    for (const Cell& cell : sorted) {
        if (cells[0].expected < 5) {
            cells[0].expected += cell.expected;
            cells[0].observed += cell.observed;
        } else {
            cells.push_back(cell);
        }
    }
    return cells;
}

}  // namespace

ZTest z_test(double estimate, double standard_error, double expected) {
    if (!(standard_error > 0)) {
        throw std::invalid_argument("z test with standard error " + std::to_string(standard_error) +
                                    "; must be above 0");
    }
    const double z = (estimate - expected) / standard_error;
    return {z, std::erfc(std::abs(z) / std::numbers::sqrt2)};
}

double chi_square_survival(double x, int k) {
    if (!(x >= 0) || k < 1) {
        throw std::invalid_argument("chi-square of " + std::to_string(x) + " with " + std::to_string(k) +
                                    " degrees of freedom; must be 0 or more with 1 or more");
    }
    if (x > std::numeric_limits<double>::max()) return 0;
    const double h   = x / 2;
    const bool   odd = k % 2 == 1;
    // log of e^-h h^a / Gamma(a + 1), from the first a = 0 or 1/2 on; Gamma(3/2) = sqrt(pi) / 2
    double       log_term = odd ? -h + 0.5 * std::log(h) - std::log(0.5 / std::numbers::inv_sqrtpi) : -h;
    double       sum      = odd ? std::erfc(std::sqrt(h)) : 0;
    for (double a = odd ? 0.5 : 0; 2 * a < k; ++a) {
        sum += std::exp(log_term);
        log_term += std::log(h / (a + 1));
    }
    return std::min(sum, 1.0);
}

ChiSquare chi_square_test(std::span<const std::uint64_t> observed, std::span<const double> expected) {
    const std::vector<Cell> sorted     = sorted_cells(observed, expected);
    const bool              impossible = std::any_of(sorted.begin(), sorted.end(),
                                                     [](Cell cell) { return cell.expected == 0 && cell.observed > 0; });
    const std::vector<Cell> cells      = pooled(sorted);
    const int               degrees    = int(cells.size()) - 1;
    if (degrees < 1)
        throw std::invalid_argument("chi-square test: one cell after pooling; must be two or more");
    if (impossible) return {std::numeric_limits<double>::infinity(), degrees, 0};

    const double statistic = std::accumulate(cells.begin(), cells.end(), 0.0, [](double sum, Cell cell) {
        const double difference = cell.observed - cell.expected;
        return sum + difference * difference / cell.expected;
    });
    return {statistic, degrees, chi_square_survival(statistic, degrees)};
}

}  // namespace sr
