#pragma once
/// @file point_pairs.hpp

#include <cstddef>
#include <utility>
#include <vector>

#include "radiosity/patch.hpp"
#include "sampling/rng.hpp"
#include "sampling/stratum.hpp"

namespace sr {

/// A point of each of two patches.
struct PointPair {
    Patch::Point p, q;
};

/// side^2 random points of a patch, one in each stratum.
/// @pre side >= 1
[[nodiscard]] inline std::vector<Patch::Point> stratified_points(const Patch& patch, int side, Rng& rng) {
    std::vector<Patch::Point> points;
    const int                 count = side * side;
    points.reserve(std::size_t(count));
    for (int k = 0; k < count; ++k) {
        const double x = rng.uniform<double>(), y = rng.uniform<double>();
        points.push_back(patch.sample(in_stratum(k, side, Vector2<double>{x, y})));
    }
    return points;
}

/// side^2 pairs of random points: each patch is cut into side^2 strata, each of which has one point; which stratum of
/// the one goes with which of the other is random, too.
/// @pre side >= 1
[[nodiscard]] inline std::vector<PointPair> stratified_pairs(const Patch& a, const Patch& b, int side,
                                                             Rng& rng) {
    const int        count = side * side;
    std::vector<int> stratum_of_b(static_cast<std::size_t>(count));
    for (int k = 0; k < count; ++k) {  // a random order, built up as it grows (Fisher and Yates)
        const auto other             = std::size_t(rng.uniform<double>() * (k + 1));
        stratum_of_b[std::size_t(k)] = k;
        std::swap(stratum_of_b[std::size_t(k)], stratum_of_b[other]);
    }
    const auto point_in = [&](const Patch& patch, int k) {
        const double x = rng.uniform<double>(), y = rng.uniform<double>();
        return patch.sample(in_stratum(k, side, Vector2<double>{x, y}));
    };
    std::vector<PointPair> pairs;
    pairs.reserve(std::size_t(count));
    for (int k = 0; k < count; ++k) {
        const auto p = point_in(a, k);
        pairs.push_back({p, point_in(b, stratum_of_b[std::size_t(k)])});
    }
    return pairs;
}

}  // namespace sr
