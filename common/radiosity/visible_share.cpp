/// @file visible_share.cpp

#include "radiosity/visible_share.hpp"

#include <utility>
#include <vector>

#include "radiosity/point_form_factors.hpp"

namespace sr {
namespace {

/// A point in the k-th of a patch's side^2 strata.
Patch::Point point_in(const Patch& patch, int k, int side, Rng& rng) {
    const double x = rng.uniform<double>(), y = rng.uniform<double>();
    return patch.sample({(k % side + x) / side, (k / side + y) / side});
}

}  // namespace

double visible_share(const Patch& a, const Patch& b, const Visibility& visibility, int side, Rng& rng) {
    std::vector<int> stratum_of_b(std::size_t(side * side));
    for (int k = 0; k < side * side; ++k) {  // a random order, built up as it grows (Fisher and Yates)
        const auto other             = std::size_t(rng.uniform<double>() * (k + 1));
        stratum_of_b[std::size_t(k)] = k;
        std::swap(stratum_of_b[std::size_t(k)], stratum_of_b[other]);
    }
    double all = 0, seen = 0;
    for (int k = 0; k < side * side; ++k) {
        const auto   p      = point_in(a, k, side, rng);
        const auto   q      = point_in(b, stratum_of_b[std::size_t(k)], side, rng);
        const double weight = form_factor_kernel(p, a.normal(), q, b.normal());
        all += weight;
        if (weight > 0 && visibility.between(a.surface_point(p), b.surface_point(q))) seen += weight;
    }
    return all > 0 ? seen / all : 1;
}

}  // namespace sr
