#pragma once
/// @file compressed_light.hpp
/// Section 6.9: photons of a sky of radiance 1 go into glass, one by one. How bright is it there?

#include <cmath>
#include <numbers>
#include <vector>

#include "material/dielectric.hpp"
#include "math/degrees.hpp"
#include "sampling/hemisphere.hpp"
#include "sampling/rng.hpp"
#include "transport/tiles.hpp"

namespace sr {

/// Radiance below the surface, counted in bands of equal sin^2(theta_t), which are bands of equal projected solid
/// angle: a radiance of 1 fills all alike.
struct CountedRadiance {
    std::vector<double> L;           ///< in each band
    std::vector<double> se;          ///< its standard error
    double              passed = 0;  ///< share of all photons
};

/// @param photons  how many, each of them pi / photons of the irradiance [W/m^2]
[[nodiscard]] inline CountedRadiance count_photons(const Dielectric<double>& glass, int photons, int bands,
                                                   int threads) {
    constexpr int                 nothing = -1, block = 1024;
    std::vector<std::vector<int>> counts(std::size_t(photons / block), std::vector<int>(std::size_t(bands)));
    for_each_pixel(photons / block, 1, {.threads = threads}, [&](int x, int) {
        Rng rng{9, x, 0, 0};
        for (int i = 0; i < block; ++i) {
            const double u = rng.uniform<double>(), v = rng.uniform<double>(), choice = rng.uniform<double>();
            const auto   from = sample_cosine_hemisphere(Vector2<double>{u, v});
            // a photon is not scaled by n^2: its weight is 1, whichever way it goes
            const auto   to   = glass.sample(from, {choice, 0}, TransportMode::importance);
            const int    band = to->wi.z < 0 ? int((1 - to->wi.z * to->wi.z) * bands) : nothing;
            if (band != nothing) ++counts[std::size_t(x)][std::size_t(band)];
        }
    });
    CountedRadiance result;
    const int       n = photons / block * block;
    for (int band = 0; band < bands; ++band) {
        double count = 0;
        for (const auto& of_block : counts) count += of_block[std::size_t(band)];
        const double share = count / n;
        result.L.push_back(share * bands);
        result.se.push_back(std::sqrt(share * (1 - share) / n) * bands);
        result.passed += share;
    }
    return result;
}

/// What a camera in the glass sees of that sky, at an angle [degrees] to the normal: the weight of what is refracted.
[[nodiscard]] inline double seen_from_inside(const Dielectric<double>& glass, double theta) {
    const Vector3<double> wo{std::sin(radians(theta)), 0, -std::cos(radians(theta))};
    const auto            both = glass.branches(wo, TransportMode::radiance);
    return both.refracted ? both.refracted->weight : 0;
}

}  // namespace sr
