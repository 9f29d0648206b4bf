#pragma once
/// @file seeds.hpp
/// Section 9.10: random numbers for each pixel, seeded in three ways.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <span>

#include "image/image.hpp"
#include "lit_floor.hpp"
#include "math/vector.hpp"
#include "moments.hpp"
#include "radiometry/spectrum.hpp"
#include "sampling/rng.hpp"
#include "statistics/running.hpp"
#include "transport/tiles.hpp"

namespace sr {

/// Park and Miller's generator, seeded with a pixel's number. Each number is 16807 times the last one, modulo 2^31 - 1:
/// so are neighbours' differences, and where one pixel goes all others follow.
class IndexSeeded {
public:
    explicit IndexSeeded(int pixel) : engine_{std::uint32_t(12345 + pixel)} {}

    /// In (0, 1).
    [[nodiscard]] double uniform() { return double(engine_()) / 2147483647; }

private:
    std::minstd_rand0 engine_;
};

/// The correlation of each value with the next one.
/// @pre three values or more, not all alike
[[nodiscard]] inline double correlation_of_neighbours(std::span<const double> values) {
    const auto first = values.first(values.size() - 1), next = values.subspan(1);
    Running    of_first, of_next, of_sum;
    for (std::size_t i = 0; i < first.size(); ++i) {
        of_first.add(first[i]);
        of_next.add(next[i]);
        of_sum.add(first[i] + next[i]);
    }
    // Var(a + b) = Var a + Var b + 2 Cov(a, b)
    const double covariance = (of_sum.variance() - of_first.variance() - of_next.variance()) / 2;
    return covariance / std::sqrt(of_first.variance() * of_next.variance());
}

/// How the numbers of a pixel are seeded.
enum class Seeding { all_alike, by_index, hashed };

/// A part of the floor, 16 samples in each pixel, around the softest shadow.
[[nodiscard]] inline Image<Spectrum> floor_seeded(Seeding seeding, int size, int samples, int threads) {
    Image<Spectrum> film(size, size);
    for_each_pixel(size, size, {.threads = threads}, [&](int x, int y) {
        const FloorPoint point({1.6 * (x + 0.5) / size - 1.7, 1.7 - 1.6 * (y + 0.5) / size});
        const bool       alike = seeding == Seeding::all_alike;
        IndexSeeded      simple(y * size + x);
        Rng              rng{1, alike ? 0 : x, alike ? 0 : y, 0};
        double           sum = 0;
        for (int k = 0; k < samples; ++k) {
            if (seeding == Seeding::by_index) {
                const double u = simple.uniform(), v = simple.uniform();
                sum += point.sample({u, v});
            } else {
                sum += point.sample(draw_pair(rng));
            }
        }
        const auto grey = float(3.5 * sum / samples);
        film(x, y)      = {grey, grey, grey};
    });
    return film;
}

}  // namespace sr
