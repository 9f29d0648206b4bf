#pragma once
/// @file two_patches.hpp
/// Two parallel disks on one axis shine at each other with the same radiance: the flux is the same both ways, though
/// neither areas nor irradiances are.

#include <cmath>
#include <numbers>

#include "geometry/ray.hpp"
#include "math/square.hpp"
#include "radiometry/emitters.hpp"
#include "sampled.hpp"
#include "sampling/disk.hpp"
#include "sampling/hemisphere.hpp"

namespace sr {

struct TwoDisks {
    double radius_1 = 1, radius_2 = 0.5, distance = 1;

    /// Of a radiance of 1, from the one to the other [W], by rays: points uniform on the area, directions as a Lambert
    /// emitter sends them, each carrying its share of pi L A; those that arrive are counted.
    [[nodiscard]] Running flux(double from, double to, const Effort& effort) const {
        const double emitted =
            lambert_flux(Radiance<double>{1}, Area<double>{std::numbers::pi * square(from)}).value();
        return sampled(effort, [&](Rng& rng) {
            const auto   start = sample_disk(random_point(rng), from);
            const auto   w     = sample_cosine_hemisphere(random_point(rng));
            const double t     = distance / w.z;
            return std::hypot(start.x + t * w.x, start.y + t * w.y) <= to ? emitted : 0;
        });
    }

    /// The same in closed form.
    /// @see Howell, A Catalog of Radiation Heat Transfer Configuration Factors, C-41
    [[nodiscard]] double exact_flux() const {
        const double a = square(radius_1 / distance), b = square(radius_2 / distance);
        const double sum = 1 + a + b;
        // (sum - root) / 2 without cancellation
        return square(std::numbers::pi * distance) * 2 * a * b / (sum + std::sqrt(square(sum) - 4 * a * b));
    }
};

}  // namespace sr
