#pragma once
/// @file far_sphere.hpp
/// How far away can a sphere be before rounding makes hits of misses?

#include <cmath>
#include <concepts>
#include <optional>

#include "each_ray.hpp"
#include "geometry/ray.hpp"
#include "geometry/sphere.hpp"
#include "math/extremes.hpp"
#include "math/quadratic.hpp"
#include "math/vector.hpp"
#include "sampling/ball.hpp"
#include "sampling/rng.hpp"
#include "statistics/estimate.hpp"

namespace sr {

template <std::floating_point T>
inline constexpr Sphere<T> unit_sphere{{0, 0, 0}, 1};

/// The t at which the line enters the unit sphere, in long double: for rays in float or double, and as far away
/// as they are here, with digits to spare. It is the same formula: only rounding is compared. That the formula is
/// right, closed forms say (tests/common/sphere.cpp).
template <std::floating_point T>
[[nodiscard]] std::optional<double> exact_entry(const Ray<T>& ray) {
    using Exact = long double;
    const auto roots =
        crossings(unit_sphere<Exact>, {Vector3<Exact>(ray.origin), Vector3<Exact>(ray.direction)});
    return roots ? std::optional(double(roots->first)) : std::nullopt;
}

/// What rounding did to rays: to whether they hit, and to where.
struct HitErrors {
    double wrong    = 0;  ///< hits and misses taken for each other [% of the rays]
    double wrong_se = 0;  ///< its standard error
    double worst_t  = 0;  ///< of the true hits that were found [radii]
};

/// Compares `method` (crossings, or textbook_crossings) with the exact answer on rays of unit length from so many
/// radii away, aimed into a ball a little larger than the sphere.
template <std::floating_point T, class Method>
[[nodiscard]] HitErrors far_sphere(double distance, int rays, int threads, const Method& method) {
    struct Outcome {
        bool   wrong = false;
        double error = 0;
    };
    const auto outcomes = each_ray(rays, threads, [&](int i) {
        Rng              rng{1, i, 0, 0};
        const Vector3<T> origin = T(distance) * normalize(in_unit_ball<T>(rng));
        const Vector3<T> target = T(1.15) * in_unit_ball<T>(rng);
        const Ray<T>     ray{origin, normalize(target - origin)};
        const auto       exact = exact_entry(ray);
        const auto       found = method(unit_sphere<T>, ray);
        if (exact.has_value() != found.has_value()) return Outcome{true, 0};
        return Outcome{false, exact ? std::abs(double(found->first) - *exact) : 0};
    });
    int        wrong    = 0;
    double     worst    = 0;
    for (const auto& outcome : outcomes) {
        wrong += outcome.wrong ? 1 : 0;
        worst = max_or_nan(worst, outcome.error);
    }
    const Estimate of_all = percent(share(wrong, outcomes.size()));
    return {of_all.value, of_all.error, worst};
}

}  // namespace sr
