#pragma once
/// @file sample_point.hpp
/// The numbers that one sample of a pixel is made of, as a point of a cube with as many dimensions as are asked for.
/// Which points the samples of a pixel are together is called a pattern:
///
///     SobolPoint point({.seed = 1, .x = x, .y = y, .index = k, .count = n});
///     const auto on_film = point.pair<float>(), on_light = point.pair<float>();

#include <concepts>
#include <cstdint>

#include "math/vector.hpp"
#include "sampling/hash.hpp"

namespace sr {

/// Which sample of which pixel.
struct SampleId {
    std::uint64_t seed  = 1;
    std::int32_t  x     = 0;
    std::int32_t  y     = 0;
    std::uint32_t index = 0;
    std::uint32_t count = 1;  ///< of samples that the pixel gets; only strata need to know

    /// A number of the pixel's own; the scrambled sums of it and 0, 1, ... are independent of each other.
    [[nodiscard]] constexpr std::uint64_t pixel_key() const { return hash(seed, x, y); }
};

/// Coordinates in [0, 1), one after the other. The two of a pair belong together, as those of a point on a lamp do.
template <class P>
concept SamplePoint = std::constructible_from<P, SampleId> && requires(P point) {
    { point.template number<float>() } -> std::same_as<float>;
    { point.template number<double>() } -> std::same_as<double>;
    { point.template pair<float>() } -> std::same_as<Vector2<float>>;
    { point.template pair<double>() } -> std::same_as<Vector2<double>>;
};

/// The next two coordinates of a point, x drawn before y.
template <std::floating_point T, class P>
[[nodiscard]] Vector2<T> next_two(P& point) {
    const T x = point.template number<T>(), y = point.template number<T>();
    return {x, y};
}

}  // namespace sr
