#pragma once
/// @file phong.hpp

#include <fmt/format.h>

#include <cmath>
#include <concepts>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "material/bsdf.hpp"
#include "material/reflect.hpp"
#include "math/frame.hpp"
#include "sampling/power_cosine.hpp"

namespace sr {

/// What the lobe cos^e is multiplied with.
enum class PhongScale {
    none,     ///< 1: as Phong wrote it. For e < 2 pi - 2 more light leaves than arrives
    density,  ///< (e + 1) / 2 pi: the lobe integrates to 1, without the cosine of the reflectance equation
    albedo    ///< (e + 2) / 2 pi: the albedo is 1 at normal incidence, and nowhere more
};

/// Phong's lobe about the mirror direction r of wo, f = c max(0, r.wi)^e: a mirror that is not quite one. Reciprocal,
/// because r(wo).wi = r(wi).wo.
/// @see Lafortune and Willems, Using the Modified Phong Reflectance Model for Physically Based Rendering (1994)
template <std::floating_point T>
class Phong {
public:
    /// @param exponent  e >= 0 [1]: 1 is dull, 1000 nearly a mirror
    /// @throws std::invalid_argument if it is negative or not finite
    explicit Phong(T exponent, PhongScale scale = PhongScale::albedo)
        : exponent_{exponent}, factor_{factor(exponent, scale)} {
        if (!(exponent >= 0 && std::isfinite(exponent)))
            throw std::invalid_argument(
                fmt::format("Phong's exponent is {}; it must be 0 or more, such as 20", exponent));
    }

    [[nodiscard]] T exponent() const { return exponent_; }

    /// The albedo at normal incidence, 2 pi c / (e + 2), where it is largest.
    [[nodiscard]] T greatest_albedo() const { return 2 * std::numbers::pi_v<T> * factor_ / (exponent_ + 2); }

    [[nodiscard]] T f(const Vector3<T>& wo, const Vector3<T>& wi) const {
        if (!(wo.z > 0 && wi.z > 0)) return 0;
        const T cosine = dot(reflect(wo), wi);
        // the power of a negative cosine is NaN, or light from behind the lobe
        return cosine > 0 ? factor_ * std::pow(cosine, exponent_) : T{0};
    }

    /// Integrates to 1 less the share of the lobe that lies below the horizon, where nothing is drawn.
    [[nodiscard]] Pdf<measure::SolidAngle> pdf(const Vector3<T>& wo, const Vector3<T>& wi) const {
        if (!(wo.z > 0 && wi.z > 0)) return {};
        return pdf_power_cosine(frame_around(reflect(wo)).to_local(wi), exponent_);
    }

    /// Draws by the lobe; none where that falls below the horizon: it is light that the surface does not give back.
    [[nodiscard]] std::optional<BsdfSample<T>> sample(const Vector3<T>& wo, Vector2<T> u,
                                                      TransportMode) const {
        if (!(wo.z > 0)) return std::nullopt;
        const Vector3<T> wi = frame_around(reflect(wo)).to_world(sample_power_cosine(u, exponent_));
        if (!(wi.z > 0)) return std::nullopt;
        // f cos / pdf, of which cos^e cancels
        const T weight = 2 * std::numbers::pi_v<T> * factor_ / (exponent_ + 1) * wi.z;
        return BsdfSample<T>{wi, weight, pdf(wo, wi)};
    }

private:
    static T factor(T exponent, PhongScale scale) {
        constexpr T turn_angle = 2 * std::numbers::pi_v<T>;
        switch (scale) {
            case PhongScale::none:
                return 1;
            case PhongScale::density:
                return (exponent + 1) / turn_angle;
            case PhongScale::albedo:
                return (exponent + 2) / turn_angle;
        }
        return 0;
    }

    T exponent_;
    T factor_;
};

}  // namespace sr
