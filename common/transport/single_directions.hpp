#pragma once
/// @file single_directions.hpp
/// A material's deltas: the few directions from which light gets into the eye undiminished, as in a mirror.

#include <concepts>
#include <variant>

#include "material/bsdf.hpp"
#include "material/lobe_sum.hpp"
#include "sampling/choice.hpp"

namespace sr {

/// Calls follow(wi, weight) for each single direction from which mirrors and glass let light into wo, with what the
/// light from there counts.
template <std::floating_point T, class Follow>
void for_each_single_direction(const LobeSum<T>& sum, const Vector3<T>& wo, const Follow& follow) {
    for (const auto& part : sum.lobes()) {
        const auto pass_on = [&](const BsdfSample<T>& one) {
            follow(one.wi, float(one.weight) * part.weight);
        };
        std::visit(
            [&]<class L>(const L& lobe) {
                if constexpr (requires { lobe.branches(wo, TransportMode::radiance); }) {
                    const auto both = lobe.branches(wo, TransportMode::radiance);
                    pass_on(both.reflected);
                    if (both.refracted) pass_on(*both.refracted);
                } else if constexpr (DeltaLobe<L, T>) {
                    if (const auto only = lobe.sample(wo, {}, TransportMode::radiance)) pass_on(*only);
                }
            },
            part.lobe);
    }
}

/// The same for one of them, drawn: a lobe by its weight, and in glass the way by its share of the light. What is
/// followed counts the more, the less often it is drawn, so that the mean over u is the sum over all.
template <std::floating_point T, class Follow>
void draw_single_direction(const LobeSum<T>& sum, const Vector3<T>& wo, Vector2<T> u, const Follow& follow) {
    const auto chance = [](const WeightedLobe<T>& part) {
        return std::visit([&]<class L>(const L&) { return DeltaLobe<L, T> ? T(mean(part.weight)) : T{0}; },
                          part.lobe);
    };
    const auto chosen = choose(sum.lobes(), chance, u.x);
    if (!chosen) return;
    const auto& part = sum.lobes()[chosen->index];
    const auto  one  = std::visit(
        [&](const auto& lobe) {
            return lobe.sample(wo, {chosen->u, u.y}, TransportMode::radiance);
        },
        part.lobe);
    if (one) follow(one->wi, float(one->weight / chosen->chance) * part.weight);
}

}  // namespace sr
