#pragma once
/// @file delta_laws.hpp
/// The laws of lobes that send light into single directions, mirrors and glass. They can't be evaluated: what they draw
/// is compared with all ways that there are. Each returns what breaks it, or nothing, as in bsdf_laws.hpp.

#include <cmath>
#include <string>
#include <vector>

#include "bsdf_laws.hpp"
#include "material/bsdf.hpp"

namespace sr::test {

/// All directions from which the lobe lets light into wo, each with what the light from there counts.
template <class Delta>
[[nodiscard]] std::vector<BsdfSample<double>> ways(const Delta& lobe, const Direction& wo,
                                                   TransportMode mode) {
    if constexpr (requires { lobe.branches(wo, mode); }) {
        const auto                      both = lobe.branches(wo, mode);
        std::vector<BsdfSample<double>> all{both.reflected};
        if (both.refracted) all.push_back(*both.refracted);
        return all;
    } else {
        const auto only = lobe.sample(wo, {0.5, 0.5}, mode);
        return only ? std::vector{*only} : std::vector<BsdfSample<double>>{};
    }
}

/// The views from above, and the same from below.
[[nodiscard]] inline std::vector<Direction> views_of_both_sides() {
    auto both = views();
    for (const Direction& wo : views()) both.push_back(-wo);
    return both;
}

/// No photon is made, and sampling finds what all ways count together, of radiance and of importance.
template <class Delta>
[[nodiscard]] std::string breaks_delta_energy(const Delta& lobe) {
    for (const Direction& wo : views_of_both_sides()) {
        for (const TransportMode mode : {TransportMode::radiance, TransportMode::importance}) {
            double albedo = 0;
            for (const auto& way : ways(lobe, wo, mode)) albedo += way.weight;
            if (mode == TransportMode::importance && !(albedo >= 0 && albedo <= 1 + 1e-12))
                return broken("energy of a delta", wo, albedo, 1);
            Rng     rng{65, 0, 0, 0};
            Running by_sampling;
            for (int i = 0; i < 20'000; ++i) {
                const double u = rng.uniform<double>(), v = rng.uniform<double>();
                const auto   one = lobe.sample(wo, {u, v}, mode);
                if (one && !(one->is_delta && one->pdf.value == 0)) return "a delta with a density";
                by_sampling.add(one ? one->weight : 0);
            }
            if (!(std::abs(by_sampling.mean() - albedo) <= 5 * by_sampling.standard_error() + 1e-12))
                return broken("energy of a delta by sampling", wo, by_sampling.mean(), albedo);
        }
    }
    return "";
}

/// Helmholtz: each way leads back to where it came from, and as much light goes back, the n^2 of radiance taken out.
template <class Delta>
[[nodiscard]] std::string breaks_delta_reciprocity(const Delta& lobe) {
    for (const Direction& wo : views_of_both_sides()) {
        for (const auto& there : ways(lobe, wo, TransportMode::importance)) {
            bool found = false;
            for (const auto& back : ways(lobe, there.wi, TransportMode::importance))
                found |= length(back.wi - wo) <= 1e-12 && std::abs(back.weight / there.weight - 1) <= 1e-12;
            if (!found) return broken("reciprocity of a delta", wo, 0, there.weight);
        }
    }
    return "";
}

}  // namespace sr::test
