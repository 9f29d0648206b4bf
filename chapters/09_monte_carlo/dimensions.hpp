#pragma once
/// @file dimensions.hpp
/// Section 9.8: grids and samples in 1 to 16 dimensions.

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "course/chapter.hpp"
#include "grids.hpp"
#include "pattern_mean.hpp"
#include "repeated.hpp"
#include "sampling/hash.hpp"
#include "sampling/owen.hpp"
#include "sampling/random_point.hpp"
#include "sampling/sobol.hpp"
#include "sampling/sobol_point.hpp"
#include "sampling/unit_interval.hpp"

namespace sr {

/// The product of pi / 2 sin(pi x) over all axes: 1 on average, in any number of dimensions, and smooth.
struct SineProduct {
    static constexpr int fewest = 1, most = 16;  ///< dimensions

    static double integral(int) { return 1; }
    double        operator()(std::span<const double> x) const {
               double product = 1;
               for (const double of : x) product *= std::numbers::pi / 2 * std::sin(std::numbers::pi * of);
        return product;
    }
};

/// 1 inside the ball around a corner, 0 outside: a 2^d-th of a unit ball, and of the cube that holds it.
struct BallPart {
    static constexpr int fewest = 2, most = 10;  ///< dimensions; in one there is no edge

    /// pi^(d/2) / (2^d Gamma(d/2 + 1))
    static double integral(int d) {
        const double half = double(d) / 2;
        return std::pow(std::numbers::pi, half) / (std::exp2(double(d)) * std::tgamma(half + 1));
    }
    double operator()(std::span<const double> x) const {
        double r2 = 0;
        for (const double of : x) r2 += of * of;
        return r2 < 1 ? 1 : 0;
    }
};

/// Sobol's points, scrambled, in as many dimensions at once as there are.
class WholeSobolPoint {
public:
    explicit WholeSobolPoint(const SampleId& id) : index_{id.index}, key_{id.pixel_key()} {}

    /// @pre called no more than sobol_dimensions times
    template <std::floating_point T>
    [[nodiscard]] T number() {
        const std::size_t   d = dimension_++;
        const std::uint32_t v = owen_scrambled(sobol(index_, d), std::uint32_t(scramble(key_ + d)));
        return to_unit_interval<T>(std::uint64_t{v} << 32);
    }

    template <std::floating_point T>
    [[nodiscard]] Vector2<T> pair() {
        return next_two<T>(*this);
    }

private:
    std::uint32_t index_;
    std::uint64_t key_;
    std::size_t   dimension_ = 0;
};

/// The error of one method in d dimensions, relative to the integral.
struct DimensionLap {
    std::string method;
    int         d;
    Estimate    error;  ///< of a grid without one of its own: it always errs alike
};

inline constexpr int points_in_all = 4096, seeds_of_a_lap = 64;

/// The RMS error over 64 seeds.
template <SamplePoint P, class F>
[[nodiscard]] Estimate sampled_error(int curve, int d, int threads, const F& f) {
    const auto once = [&](std::uint64_t seed) {
        return pattern_mean<P>(curve, seed, points_in_all, [&](P& point) {
            std::array<double, 16> x;
            const std::span        used(x.data(), std::size_t(d));
            for (double& of : used) of = point.template number<double>();
            return f(used) / F::integral(d);
        });
    };
    return root_mean_square(squared_errors(seeds_of_a_lap, threads, 1, once));
}

template <class F>
[[nodiscard]] std::vector<DimensionLap> run_dimensions(int curve, int threads, const F& f) {
    std::vector<DimensionLap> laps;
    // more points along an axis would change no digit, and take long to find
    const auto                gauss = [](int n) { return gauss_legendre(std::min(n, 64), 0, 1); };
    for (const int d : {1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 16}) {
        if (d < F::fewest || d > F::most) continue;
        const auto sides = grid_sides(points_in_all, d);
        const auto grid  = [&](const auto& rule) {
            return Estimate{std::abs(grid_integral(sides, rule, f) / F::integral(d) - 1), 0};
        };
        laps.push_back({"midpoints", d, grid(midpoint_rule)});
        laps.push_back({"Gauss", d, grid(gauss)});
        laps.push_back({"random", d, sampled_error<RandomPoint>(curve, d, threads, f)});
        laps.push_back({"Sobol', in fours", d, sampled_error<SobolPoint>(curve + 1, d, threads, f)});
        laps.push_back({"Sobol', as one", d, sampled_error<WholeSobolPoint>(curve + 2, d, threads, f)});
    }
    return laps;
}

}  // namespace sr
