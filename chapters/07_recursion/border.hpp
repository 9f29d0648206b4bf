#pragma once
/// @file border.hpp
/// Section 7.8: angles at which light is just reflected totally, or just not.

#include <cmath>
#include <vector>

#include "material/reflect.hpp"
#include "sampling/rng.hpp"

namespace sr {

/// Cosines of the refracted angle that are no number, and directions that are no unit vectors, of so many angles.
struct BorderCount {
    int school_is_nan = 0;
    int core_is_wrong = 0;
};

/// The school's cos(theta_t) from inside glass of index n: the root is drawn before anybody asks.
[[nodiscard]] inline float school_cosine(float cos_i, float n) {
    return std::sqrt(1 - n * n * (1 - cos_i * cos_i));
}

/// Angles of incidence from inside glass within 10^-4 rad of the border. The core is wrong where what it returns is no
/// unit vector on the other side, or is none where light gets out; angles nearer than rounding, 3 10^-7 rad, may be
/// either.
[[nodiscard]] inline BorderCount count_at_border(int angles) {
    constexpr float n      = 1.5F;
    const double    border = std::asin(1 / 1.5);
    BorderCount     count;
    Rng             rng{46, 0, 0, 0};
    for (int i = 0; i < angles; ++i) {
        const double theta = border + 1e-4 * (2 * rng.uniform<double>() - 1);
        const Vec3   wo(Vector3<double>{std::sin(theta), 0, -std::cos(theta)});
        const auto   wi = refract(wo, 1 / n);
        count.school_is_nan += std::isnan(school_cosine(std::abs(wo.z), n)) ? 1 : 0;
        const bool good = !wi || (wi->z > 0 && std::abs(length(*wi) - 1) <= 1e-6F);
        const bool side = std::abs(theta - border) < 3e-7 || wi.has_value() == (theta < border);
        count.core_is_wrong += good && side ? 0 : 1;
    }
    return count;
}

}  // namespace sr
