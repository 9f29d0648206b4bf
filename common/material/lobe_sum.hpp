#pragma once
/// @file lobe_sum.hpp
/// A material is a sum of lobes, each with its colour: scattering is linear.

#include <fmt/format.h>

#include <cmath>
#include <concepts>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "material/bsdf.hpp"
#include "material/dielectric.hpp"
#include "material/diffuse.hpp"
#include "material/mirror.hpp"
#include "radiometry/spectrum.hpp"

namespace sr {

/// All lobes there are.
template <std::floating_point T>
using Lobe = std::variant<Diffuse<T>, Mirror<T>, Dielectric<T>>;

template <std::floating_point T>
struct WeightedLobe {
    Spectrum weight;  ///< share of the light that this lobe scatters, 0 to 1 [1]
    Lobe<T>  lobe;
};

/// The sum of weighted lobes. As no lobe gives back more light than it gets, nor does a sum whose weights add up to
/// at most 1: energy is conserved because the constructor says so.
template <std::floating_point T>
class LobeSum {
public:
    /// Black, and opaque.
    LobeSum() = default;

    /// @throws std::invalid_argument if a weight isn't from 0 to 1, or if in a channel they add up to more than 1
    explicit LobeSum(std::vector<WeightedLobe<T>> lobes) : lobes_{std::move(lobes)} {
        Spectrum sum;
        for (const auto& [weight, lobe] : lobes_) {
            if (!each_in(weight, 0, 1)) refuse("a lobe's weight", weight);
            sum = sum + weight;
        }
        constexpr float rounding = 1 + 1e-6F;  // 0.7 + 0.3 may exceed 1 by a last digit
        if (!each_in(sum, 0, rounding)) refuse("the sum of the lobes' weights", sum);
    }

    [[nodiscard]] const std::vector<WeightedLobe<T>>& lobes() const { return lobes_; }

    /// [1/sr], of the lobes that have an f: deltas can only be sampled.
    [[nodiscard]] Spectrum f(const Vector3<T>& wo, const Vector3<T>& wi) const {
        Spectrum sum;
        for (const auto& part : lobes_) sum = sum + float(f_of(part.lobe, wo, wi)) * part.weight;
        return sum;
    }

    /// The density with which `sample` draws wi, deltas aside.
    [[nodiscard]] Pdf<measure::SolidAngle> pdf(const Vector3<T>& wo, const Vector3<T>& wi) const {
        Pdf<measure::SolidAngle> sum;
        for (const auto& part : lobes_) sum.value += chance(part) * pdf_of(part.lobe, wo, wi).value;
        return sum;
    }

    /// Draws from one of the lobes, which is chosen as often as its mean weight demands.
    [[nodiscard]] std::optional<BsdfSample<T, Spectrum>> sample(
        const Vector3<T>& wo, Vector2<T> u, TransportMode mode = TransportMode::radiance) const {
        for (const auto& part : lobes_) {
            const auto p = T(chance(part));
            if (u.x >= p) {
                u.x -= p;
                continue;
            }
            u.x /= p;  // uniform again: what is left of the number that chose
            const auto one =
                std::visit([&](const auto& lobe) { return lobe.sample(wo, u, mode); }, part.lobe);
            if (!one) return std::nullopt;
            if (one->is_delta)
                return BsdfSample<T, Spectrum>{one->wi, float(one->weight / p) * part.weight, {}, true};
            const auto density = pdf(wo, one->wi);
            if (!(density.value > 0)) return std::nullopt;
            return BsdfSample<T, Spectrum>{
                one->wi, float(std::abs(one->wi.z) / density.value) * f(wo, one->wi), density};
        }
        return std::nullopt;
    }

private:
    [[noreturn]] static void refuse(const char* what, Spectrum s) {
        throw std::invalid_argument(
            fmt::format("{} is ({}, {}, {}); each must be from 0 to 1", what, s.r, s.g, s.b));
    }

    static T f_of(const Lobe<T>& lobe, const Vector3<T>& wo, const Vector3<T>& wi) {
        return std::visit(
            [&]<class L>(const L& one) {
                if constexpr (Bsdf<L, T>)
                    return one.f(wo, wi);
                else
                    return T{0};
            },
            lobe);
    }

    static Pdf<measure::SolidAngle> pdf_of(const Lobe<T>& lobe, const Vector3<T>& wo, const Vector3<T>& wi) {
        return std::visit(
            [&]<class L>(const L& one) {
                if constexpr (Bsdf<L, T>)
                    return one.pdf(wo, wi);
                else
                    return Pdf<measure::SolidAngle>{};
            },
            lobe);
    }

    [[nodiscard]] double chance(const WeightedLobe<T>& part) const {
        double sum = 0;
        for (const auto& other : lobes_) sum += double(mean(other.weight));
        return sum > 0 ? double(mean(part.weight)) / sum : 0;
    }

    std::vector<WeightedLobe<T>> lobes_;
};

}  // namespace sr
