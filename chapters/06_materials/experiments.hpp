#pragma once
/// @file experiments.hpp
/// Section 6.3: the four laws, tried on pairs of random directions above the surface.

#include <cmath>
#include <string>
#include <vector>

#include "material/lobe_sum.hpp"
#include "math/extremes.hpp"
#include "reflected.hpp"
#include "sampling/hemisphere.hpp"
#include "sampling/rng.hpp"
#include "skies.hpp"
#include "textbook.hpp"

namespace sr {

/// Calls of(wo, wi) for so many pairs, each direction uniform above the surface.
template <class Of>
void for_pairs(int count, const Of& of) {
    Rng rng{3, 0, 0, 0};
    for (int i = 0; i < count; ++i) {
        const double a = rng.uniform<double>(), b = rng.uniform<double>();
        const double c = rng.uniform<double>(), d = rng.uniform<double>();
        of(sample_uniform_hemisphere(Vector2<double>{a, b}),
           sample_uniform_hemisphere(Vector2<double>{c, d}));
    }
}

/// Of all pairs, those where the unclamped lobe is not what it should be, 0 [%]; any value that is neither, negative
/// and NaN counts.
[[nodiscard]] inline double percent_wrong_behind(double e, int pairs) {
    int wrong = 0;
    for_pairs(pairs, [&](const auto& wo, const auto& wi) {
        const double f = textbook_phong(wo, wi, e);
        wrong += f == Phong<double>(e, PhongScale::none).f(wo, wi) ? 0 : 1;
    });
    return 100.0 * wrong / pairs;
}

/// The largest |f(wo, wi) - f(wi, wo)| relative to the larger of the two.
template <class Lobe>
[[nodiscard]] double worst_reciprocity(const Lobe& lobe, int pairs) {
    double worst = 0;
    for_pairs(pairs, [&](const auto& wo, const auto& wi) {
        const double there = lobe.f(wo, wi), back = lobe.f(wi, wo), larger = max_or_nan(there, back);
        if (!(larger == 0)) worst = max_or_nan(worst, std::abs(there - back) / larger);
    });
    return worst;
}

/// The largest albedo from 0 to 85 degrees.
template <class Lobe>
[[nodiscard]] double largest_albedo(const Lobe& lobe, const HemisphereRule& rule) {
    double largest = 0;
    for (double theta = 0; theta <= 85; theta += 5)
        largest = max_or_nan(largest, albedo(lobe, at_angle(theta), rule));
    return largest;
}

/// What leaves a sum of two lobes, and the sum of what leaves each [L of the zenith].
struct Linearity {
    double of_sum, sum_of;
};

[[nodiscard]] inline Linearity linearity(const HemisphereRule& rule) {
    const ClearSky        sky{at_angle(45)};
    const auto            wo = at_angle(-60);
    const Phong<double>   glossy(20);
    const LobeSum<double> sum{{{{0.5F, 0.5F, 0.5F}, Diffuse<double>{}}, {{0.25F, 0.25F, 0.25F}, glossy}}};
    struct Green {
        const LobeSum<double>& sum;
        [[nodiscard]] double   f(const Vector3<double>& o, const Vector3<double>& i) const {
              return double(sum.f(o, i).g);
        }
    };
    return {reflected(Green{sum}, sky, wo, rule),
            0.5 * reflected(Diffuse<double>{}, sky, wo, rule) + 0.25 * reflected(glossy, sky, wo, rule)};
}

}  // namespace sr
