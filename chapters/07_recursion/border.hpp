#pragma once
/// @file border.hpp
/// Section 7.8: angles at which light is just reflected totally, or just not.

#include <cmath>
#include <numbers>
#include <vector>

#include "course/chapter.hpp"
#include "material/reflect.hpp"
#include "sampling/rng.hpp"
#include "statistics/estimate.hpp"

namespace sr {

/// Of so many angles: the cosines of the refracted angle that are no number, and the answers of the core that are
/// wrong.
struct BorderCount {
    int school_is_nan = 0;
    int core_is_wrong = 0;
};

/// The school's cos(theta_t) from inside glass of index n: the root is drawn before anybody asks.
[[nodiscard]] inline float school_cosine(float cos_i, float n) {
    return std::sqrt(1 - n * n * (1 - cos_i * cos_i));
}

/// Directions inside glass at a distance from the border [rad], every other one beyond it. The core is wrong where it
/// returns none though light gets out, one though it doesn't, or none of length one on the other side.
[[nodiscard]] inline BorderCount count_at_border(double distance, int angles) {
    constexpr float n      = 1.5F;
    const double    border = std::asin(1 / 1.5);
    BorderCount     count;
    Rng             rng{46, 0, 0, 0};
    for (int i = 0; i < angles; ++i) {
        const bool   beyond = i % 2 == 1;
        const double theta  = beyond ? border + distance : border - distance;
        const double phi    = 2 * std::numbers::pi * rng.uniform<double>();
        const Vec3   wo(Vector3<double>{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                                        -std::cos(theta)});
        const auto   wi   = refract(wo, 1 / n);
        const bool   good = !wi || (wi->z > 0 && std::abs(length(*wi) - 1) <= 1e-6F);
        count.school_is_nan += std::isnan(school_cosine(std::abs(wo.z), n)) ? 1 : 0;
        count.core_is_wrong += good && wi.has_value() != beyond ? 0 : 1;
    }
    return count;
}

/// The angles for each distance, and the distances from the border [rad].
inline constexpr int             angles_at_border = 20'000;
inline const std::vector<double> border_distances{1e-9, 1e-8, 3e-8, 1e-7, 1e-6, 1e-5,
                                                  1e-4, 1e-3, 1e-2, 0.1,  0.5};

/// The share of wrong answers, with its standard error.
inline void chart_border(course::Chart chart) {
    for (const double distance : border_distances) {
        const auto count = count_at_border(distance, angles_at_border);
        chart.add("textbook: the root is NaN", distance,
                  percent(share(count.school_is_nan, angles_at_border)));
        chart.add("core: asked first", distance, percent(share(count.core_is_wrong, angles_at_border)));
    }
}

}  // namespace sr
