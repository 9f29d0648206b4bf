#pragma once
/// @file hemisphere_variances.hpp
/// The variance of one sample of an irradiance, exactly and measured: cosines' powers, and a lamp that is a cap of the
/// sky about the zenith.

#include <cmath>
#include <cstdint>
#include <numbers>

#include "math/square.hpp"
#include "moments.hpp"
#include "sampling/cone.hpp"
#include "sampling/hemisphere.hpp"

namespace sr {

/// Directions with their densities; which, is a type each.
struct UniformDirections {
    [[nodiscard]] Vector3<double> sample(Vector2<double> u) const { return sample_uniform_hemisphere(u); }
    [[nodiscard]] double pdf(const Vector3<double>& w) const { return pdf_uniform_hemisphere(w).value; }
};

struct CosineDirections {
    [[nodiscard]] Vector3<double> sample(Vector2<double> u) const { return sample_cosine_hemisphere(u); }
    [[nodiscard]] double pdf(const Vector3<double>& w) const { return pdf_cosine_hemisphere(w).value; }
};

/// Those to the lamp alone.
struct ConeDirections {
    double sine;

    [[nodiscard]] Vector3<double> sample(Vector2<double> u) const { return sample_cone(u, sine); }
    [[nodiscard]] double          pdf(const Vector3<double>& w) const { return pdf_cone(w, sine).value; }
};

/// Mean and variance of f(w) / p(w).
/// @param f  (w) -> what is integrated over the hemisphere
template <class F, class Directions>
[[nodiscard]] Moments moments_over_hemisphere(const F& f, const Directions& p, std::uint64_t stream,
                                              int threads) {
    const auto draw = [&](Rng& rng) {
        const auto w = p.sample(draw_pair(rng));
        return f(w) / p.pdf(w);
    };
    return moments_of(stream, draw, threads);
}

/// What is left of the sky where only a cap about the zenith shines, by the sine of its half-angle: cosine times
/// radiance, 1 in the cap.
struct CapLight {
    double sine;

    [[nodiscard]] double operator()(const Vector3<double>& w) const {
        return square(w.x) + square(w.y) < square(sine) ? w.z : 0;
    }
    [[nodiscard]] double irradiance() const { return std::numbers::pi * square(sine); }
};

/// Exact variances of a sample of the integral of cos^e, 2 pi / (e + 1).
[[nodiscard]] inline double power_variance(const UniformDirections&, double e) {
    return 4 * square(std::numbers::pi) * (1 / (2 * e + 1) - 1 / square(e + 1));
}

[[nodiscard]] inline double power_variance(const CosineDirections&, double e) {
    return square(std::numbers::pi) * (1 / e - 4 / square(e + 1));
}

/// Exact variances of a sample of a cap's irradiance: the second moment less the mean's square.
[[nodiscard]] inline double cap_variance(const UniformDirections&, const CapLight& cap) {
    const double c = std::sqrt((1 - cap.sine) * (1 + cap.sine));
    return 4 * square(std::numbers::pi) / 3 * (1 - c * c * c) - square(cap.irradiance());
}

[[nodiscard]] inline double cap_variance(const CosineDirections&, const CapLight& cap) {
    return cap.irradiance() * (std::numbers::pi - cap.irradiance());
}

/// Omega^2 times the variance of a number between c and 1, each as likely: (1 - c)^2 / 12.
[[nodiscard]] inline double cap_variance(const ConeDirections&, const CapLight& cap) {
    return square(2 * std::numbers::pi * square(cone_height(cap.sine))) / 12;
}

}  // namespace sr
