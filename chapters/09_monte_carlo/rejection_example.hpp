#pragma once
/// @file rejection_example.hpp
/// Waves that fade, f = e^-x (1 + sin 4x) / 2, drawn by rejection from p = e^-x; their integral is 21/34.

#include <cmath>
#include <stdexcept>

#include "sampling/rejection.hpp"
#include "sampling/rng.hpp"

namespace sr {

constexpr double waves_integral = 21.0 / 34;

[[nodiscard]] inline double waves(double x) {
    return std::exp(-x) * (1 + std::sin(4 * x)) / 2;
}

[[nodiscard]] inline double fading(double x) {
    return std::exp(-x);
}

[[nodiscard]] inline double draw_fading(Rng& rng) {
    return -std::log1p(-rng.uniform<double>());
}

/// The loop as it is written first: it never asks whether f <= c p.
[[nodiscard]] inline double trusting_rejection(Rng& rng, double c) {
    for (;;) {
        const double xi = rng.uniform<double>(), x = draw_fading(rng);
        if (xi * c * fading(x) <= waves(x)) return x;
    }
}

/// How many numbers the tool draws until it notices that c is too small.
/// @throws std::runtime_error if it does not within `most`
[[nodiscard]] inline int draws_until_noticed(Rng& rng, double c, int most) {
    for (int draws = 1; draws <= most; ++draws) {
        try {
            (void)sample_by_rejection(rng, draw_fading, fading, c, waves, 1);
        } catch (const std::domain_error&) {
            return draws;
        }
    }
    throw std::runtime_error("rejection: an envelope that is too low was not noticed");
}

}  // namespace sr
