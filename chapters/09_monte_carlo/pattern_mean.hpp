#pragma once
/// @file pattern_mean.hpp

#include <cstdint>

#include "math/vector.hpp"
#include "sampling/sample_point.hpp"

namespace sr {

/// The mean of `of` over n points of a pattern: what a pixel's samples estimate.
/// @param curve  patterns of other curves, seeds or n are independent of this one: with the same random numbers, all
///               curves of a chart would err alike
/// @param of     (P&) -> a value, from as many of the point's numbers as it takes
template <SamplePoint P, class Of>
[[nodiscard]] double pattern_mean(int curve, std::uint64_t seed, std::uint32_t n, const Of& of) {
    double sum = 0;
    for (std::uint32_t i = 0; i < n; ++i) {
        P point({.seed = seed, .x = std::int32_t(n), .y = curve, .index = i, .count = n});
        sum += of(point);
    }
    return sum / n;
}

/// A function of the unit square as one of a point.
template <class F>
[[nodiscard]] auto of_pair(const F& f) {
    return [f](auto& point) { return f(point.template pair<double>()); };
}

/// A function of the unit interval as one of a point.
template <class F>
[[nodiscard]] auto of_number(const F& f) {
    return [f](auto& point) { return f(point.template number<double>()); };
}

}  // namespace sr
