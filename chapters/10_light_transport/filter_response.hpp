#pragma once
/// @file filter_response.hpp
/// Section 10.8: which share of a wave's height a pixel filter leaves.

#include <cmath>
#include <cstdint>
#include <numbers>

#include "math/gauss_legendre.hpp"
#include "sampling/random_point.hpp"
#include "sampling/sobol_point.hpp"
#include "statistics/estimate.hpp"
#include "statistics/running.hpp"
#include "transport/pixel_filter.hpp"

namespace sr {

/// sin(pi f) / (pi f), 1 at 0.
[[nodiscard]] inline double sinc(double f) {
    const double x = std::numbers::pi * f;
    return x == 0 ? 1 : std::sin(x) / x;
}

/// Of the Gaussian that goes on for ever: exp(-2 pi^2 s^2 f^2), s = 0.5.
[[nodiscard]] inline double response_of_gaussian(double f) {
    return std::exp(-std::numbers::pi * std::numbers::pi * f * f / 2);
}

/// The same of the one that ends at 2 pixels: the integral over the disk, along its radii and around.
[[nodiscard]] inline double response_of_cut_gaussian(double f) {
    constexpr int directions = 64;
    double        sum        = 0;
    for (const auto& [r, weight] : gauss_legendre(48, 0, 2)) {
        double around = 0;
        for (int i = 0; i < directions; ++i) {
            const double phi = 2 * std::numbers::pi * (i + 0.5) / directions;
            around += std::cos(2 * std::numbers::pi * f * r * std::cos(phi)) / directions;
        }
        sum += weight * 4 * r * std::exp(-2 * r * r) * around;
    }
    return sum / (1 - std::exp(-8));
}

/// The filter's response to waves of f per pixel, equation (10.24).
[[nodiscard]] inline double filter_response(PixelFilter filter, double f) {
    switch (filter) {
        case PixelFilter::box:
            return sinc(f);
        case PixelFilter::tent:
            return sinc(f) * sinc(f);
        case PixelFilter::gaussian:
            return response_of_cut_gaussian(f);
    }
    return 0;
}

/// The same, measured: the mean of a wave whose crest lies in the pixel's middle.
/// @tparam P  pattern of the samples
template <SamplePoint P>
[[nodiscard]] Estimate measured_response(PixelFilter filter, double f, std::uint32_t samples) {
    Running wave;
    for (std::uint32_t i = 0; i < samples; ++i) {
        P            point(SampleId{.seed = 1018, .index = i, .count = samples});
        const double x = double(sample_filter(filter, point.template pair<float>()).x) - 0.5;
        wave.add(std::cos(2 * std::numbers::pi * f * x));
    }
    return {wave.mean(), wave.standard_error()};
}

}  // namespace sr
