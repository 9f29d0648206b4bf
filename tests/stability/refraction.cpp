/// @file refraction.cpp
/// Where refraction ends and total reflection begins: row S46.

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "catalogue.hpp"
#include "material/dielectric.hpp"
#include "sampling/rng.hpp"

using namespace sr;
using test::within_factor_3;

namespace {

/// The school's cos(theta_t), from inside glass of index n: the root is drawn before anybody asks.
float textbook_cosine(float cos_i, float n) {
    return std::sqrt(1 - n * n * (1 - cos_i * cos_i));
}

}  // namespace

TEST_CASE(
    "S46: at the border of total reflection the root is NaN for half of the angles; the core has none") {
    constexpr int angles       = 100'000;
    const float   n            = 1.5F;
    const double  border       = std::asin(1 / 1.5);
    int           not_a_number = 0, core_not_finite = 0, wrong_side = 0, wrong_sign = 0;
    Rng           rng{46, 0, 0, 0};
    for (int i = 0; i < angles; ++i) {
        const double theta = border + 1e-4 * (2 * rng.uniform<double>() - 1);
        const Vec3   wo(Vector3<double>{std::sin(theta), 0, -std::cos(theta)});  // from inside
        not_a_number += std::isnan(textbook_cosine(std::abs(wo.z), n)) ? 1 : 0;

        const auto wi = refract(wo, 1 / n);
        if (wi) {
            wrong_sign += wi->z > 0 ? 0 : 1;
            core_not_finite += std::abs(length(*wi) - 1) <= 1e-6F ? 0 : 1;
        }
        // rounding moves the border by a few units of the last place of the sine, 10^-7 rad
        if (std::abs(theta - border) >= 3e-7) wrong_side += wi.has_value() == (theta < border) ? 0 : 1;
        const auto both = Dielectric<float>{n}.branches(wo, TransportMode::importance);
        const auto sum  = both.reflected.weight + (both.refracted ? both.refracted->weight : 0);
        core_not_finite += std::abs(sum - 1) <= 1e-6F ? 0 : 1;
    }
    CHECK(within_factor_3(not_a_number / double(angles), 0.5));
    CHECK(core_not_finite == 0);
    CHECK(wrong_sign == 0);
    CHECK(wrong_side == 0);
}
