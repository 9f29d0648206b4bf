#pragma once
/// @file stated_error.hpp
/// Section 10.10: is the error that a picture states true?

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include "error_race.hpp"
#include "math/square.hpp"
#include "statistics/running.hpp"

namespace sr {

/// What pictures of the box, of so many passes with 4 samples each, state and are.
struct StatedErrors {
    std::vector<double> deviations = {};            ///< of pixels that count: (I - R) / standard error
    Running             stated = {}, reached = {};  ///< squared errors of pictures, over the mean squared
};

/// The mean squared error of brightness over the squared mean, less what the reference errs by itself.
[[nodiscard]] inline double squared_error(const ErrorRace& race, const Image<Spectrum>& film) {
    const auto truth = race.reference().mean();
    Running    squares;
    for (std::size_t i = 0; i < race.mask().pixels().size(); ++i)
        if (race.mask().pixels()[i] != 0)
            squares.add(square(double(mean(film.pixels()[i])) - double(mean(truth.pixels()[i]))));
    return squares.mean() / square(radiance_of(truth, race.mask())) - square(race.error_of_reference());
}

[[nodiscard]] inline StatedErrors stated_errors(const ErrorRace& race, int passes, int pictures,
                                                const TileLoop& loop) {
    StatedErrors all;
    const auto   truth = race.reference().mean();
    for (int i = 0; i < pictures; ++i) {
        const auto image  = traced(race.scene(), race.camera(), {},
                                   {.seed = std::uint64_t(1200 + i), .samples = 4}, loop, passes);
        const auto film   = image.mean();
        const auto errors = image.standard_errors();
        for (std::size_t p = 0; p < film.pixels().size(); ++p)
            if (race.mask().pixels()[p] != 0 && errors.pixels()[p] > 0)
                all.deviations.push_back((double(mean(film.pixels()[p])) - double(mean(truth.pixels()[p]))) /
                                         double(errors.pixels()[p]));
        all.stated.add(square(image.relative_error(race.mask())));
        all.reached.add(squared_error(race, film));
    }
    return all;
}

/// The density of Student's t: of a mean over its own standard error, if what is averaged is normal.
[[nodiscard]] inline double student_density(double t, double degrees) {
    const double half = (degrees + 1) / 2;
    return std::exp(std::lgamma(half) - std::lgamma(degrees / 2)) / std::sqrt(degrees * std::numbers::pi) *
           std::pow(1 + t * t / degrees, -half);
}

/// The share of deviations below `from`, or above `to`.
struct Outside {
    double below, above;
};
[[nodiscard]] inline Outside outside(const std::vector<double>& deviations, double from, double to) {
    double below = 0, above = 0;
    for (const double d : deviations) {
        below += d < from ? 1 : 0;
        above += d > to ? 1 : 0;
    }
    return {below / double(deviations.size()), above / double(deviations.size())};
}

}  // namespace sr
