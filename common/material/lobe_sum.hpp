#pragma once
/// @file lobe_sum.hpp
/// A material is a sum of lobes, each with its colour: scattering is linear.

#include <fmt/format.h>

#include <cmath>
#include <concepts>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

#include "material/bsdf.hpp"
#include "material/dielectric.hpp"
#include "material/diffuse.hpp"
#include "material/mirror.hpp"
#include "material/phong.hpp"
#include "radiometry/spectrum.hpp"
#include "sampling/choice.hpp"

namespace sr {

/// All lobes there are.
template <std::floating_point T>
using Lobe = std::variant<Diffuse<T>, Mirror<T>, Phong<T>, Dielectric<T>>;

template <std::floating_point T>
struct WeightedLobe {
    Spectrum weight;  ///< share of the light that this lobe scatters, 0 to 1 [1]
    Lobe<T>  lobe;
};

/// The most that a lobe gives back of the light from any one direction: 1, but for one that says otherwise.
template <std::floating_point T>
[[nodiscard]] T greatest_albedo(const Lobe<T>& lobe) {
    return std::visit(
        [](const auto& one) {
            if constexpr (requires { one.greatest_albedo(); })
                return one.greatest_albedo();
            else
                return T{1};
        },
        lobe);
}

/// The sum of weighted lobes: a Bsdf whose values are spectra. It gives back no more light than it gets, in no channel
/// and from no direction, because its constructor adds up what its lobes can give back at most.
template <std::floating_point T>
class LobeSum {
public:
    /// Black, and opaque.
    LobeSum() = default;

    /// @throws std::invalid_argument if a weight isn't from 0 to 1, or if in a channel the lobes' greatest albedos,
    ///         weighted, add up to more than 1
    explicit LobeSum(std::vector<WeightedLobe<T>> lobes) : lobes_{std::move(lobes)} {
        Spectrum sum;
        for (const auto& [weight, lobe] : lobes_) {
            if (!each_in(weight, 0, 1)) refuse("a lobe's weight", weight);
            sum = sum + float(greatest_albedo(lobe)) * weight;
        }
        constexpr float rounding = 1 + 1e-6F;  // 0.7 + 0.3 may exceed 1 by a last digit
        if (!each_in(sum, 0, rounding)) refuse("the albedo of the lobes' sum", sum);
        share_out();
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
        for (std::size_t i = 0; i < lobes_.size(); ++i)
            sum.value += chances_[i] * pdf_of(lobes_[i].lobe, wo, wi).value;
        return sum;
    }

    /// Draws from one of the lobes, each as often as its share of the light.
    [[nodiscard]] std::optional<BsdfSample<T, Spectrum>> sample(const Vector3<T>& wo, Vector2<T> u,
                                                                TransportMode mode) const {
        if (chances_.size() == 1 && chances_[0] > 0) return only_lobe(wo, u, mode);
        const auto one = choose(
            chances_, [](double chance) { return T(chance); }, u.x);
        if (!one) return std::nullopt;
        return weighted(lobes_[one->index], one->chance, wo, {one->u, u.y}, mode);
    }

private:
    [[nodiscard]] std::optional<BsdfSample<T, Spectrum>> only_lobe(const Vector3<T>& wo, Vector2<T> u,
                                                                   TransportMode mode) const {
        const auto& [weight, lobe] = lobes_[0];
        const auto one = std::visit([&](const auto& lobe_) { return lobe_.sample(wo, u, mode); }, lobe);
        if (!one) return std::nullopt;
        return BsdfSample<T, Spectrum>{one->wi, float(one->weight) * weight, one->pdf, one->is_delta,
                                       one->squeezed};
    }

    /// What one lobe, chosen with probability p, draws. Of lobes that spread light the whole sum's f and pdf count.
    [[nodiscard]] std::optional<BsdfSample<T, Spectrum>> weighted(const WeightedLobe<T>& part, T p,
                                                                  const Vector3<T>& wo, Vector2<T> u,
                                                                  TransportMode mode) const {
        const auto one = std::visit([&](const auto& lobe) { return lobe.sample(wo, u, mode); }, part.lobe);
        if (!one) return std::nullopt;
        if (one->is_delta)
            return BsdfSample<T, Spectrum>{
                one->wi, float(one->weight / p) * part.weight, {}, true, one->squeezed};
        const auto density = pdf(wo, one->wi);
        if (!(density.value > 0)) return std::nullopt;
        return BsdfSample<T, Spectrum>{one->wi, float(std::abs(one->wi.z) / density.value) * f(wo, one->wi),
                                       density};
    }

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

    /// A lobe's chance is its share of what all give back at most, the mean of the channels.
    void share_out() {
        double sum = 0;
        for (const auto& [weight, lobe] : lobes_) {
            chances_.push_back(double(mean(weight)) * double(greatest_albedo(lobe)));
            sum += chances_.back();
        }
        for (double& chance : chances_) chance = sum > 0 ? chance / sum : 0;
    }

    std::vector<WeightedLobe<T>> lobes_;
    std::vector<double>          chances_;  ///< with which each is drawn
};

}  // namespace sr
