/// @file gauss_legendre.cpp

#include "math/gauss_legendre.hpp"

#include <doctest/doctest.h>

#include <cmath>

namespace {

using namespace sr;

/// The rule's integral of x^power over [-1, 1], less the true one.
double error(int n, int power) {
    double sum = 0;
    for (const auto& [x, weight] : gauss_legendre(n)) sum += weight * std::pow(x, power);
    return std::abs(sum - (power % 2 == 0 ? 2.0 / (power + 1) : 0));
}

}  // namespace

TEST_CASE("Gauss-Legendre: n points are exact to degree 2n - 1, and no further") {
    for (const int n : {1, 2, 3, 8, 21}) {
        for (int power = 0; power <= 2 * n - 1; ++power) CHECK(error(n, power) <= 1e-14);
        CHECK(error(n, 2 * n) >= 1e-13);
    }
}

TEST_CASE("Gauss-Legendre: the rule of two points, and an interval of one's own") {
    const auto rule = gauss_legendre(2, 1, 3);
    REQUIRE(rule.size() == 2);
    CHECK(std::abs(rule[0].x - (2 - 1 / std::sqrt(3.0))) <= 1e-15);
    CHECK(std::abs(rule[1].x - (2 + 1 / std::sqrt(3.0))) <= 1e-15);
    CHECK(std::abs(rule[0].weight - 1) <= 1e-15);
    CHECK(std::abs(rule[1].weight - 1) <= 1e-15);
}

TEST_CASE("Gauss-Legendre: hundreds of points, of a smooth function to the last digits") {
    double sum = 0;
    for (const auto& [x, weight] : gauss_legendre(500, 0, 1)) sum += weight * std::exp(x);
    CHECK(std::abs(sum - (std::exp(1.0) - 1)) <= 1e-14);
}
