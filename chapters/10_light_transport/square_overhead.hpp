#pragma once
/// @file square_overhead.hpp

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "math/gauss_legendre.hpp"
#include "math/square.hpp"
#include "radiosity/rows.hpp"
#include "sampling/rng.hpp"
#include "scene/small_scenes.hpp"
#include "statistics/estimate.hpp"
#include "statistics/running.hpp"
#include "transport/emitters.hpp"

namespace sr {

/// A lamp of two triangles, a square of side 2, over the middle of which its light is measured: irradiance by one
/// direction to it.
class SquareOverhead {
public:
    explicit SquareOverhead(double height) : h_{height} {}

    /// Standard deviation over the mean, in closed form: in polar coordinates about the middle all but the angle of
    /// the integral of (A h^2 / r^4)^2 / A is known, as (9.18) is.
    [[nodiscard]] double deviation_by_area() const {
        const double second = over_angles(
            [&](double far) { return 4 * std::pow(h_, 4) * (std::pow(h_, -6) - std::pow(far, -6)) / 6; });
        return std::sqrt(second / square(irradiance()) - 1);
    }
    /// A direction counts cos times the solid angle, of which each triangle has half.
    [[nodiscard]] double deviation_by_solid_angle() const {
        const double solid_angle = over_angles([&](double far) { return 1 - h_ / far; });
        const double second =
            solid_angle * over_angles([&](double far) { return (1 - std::pow(h_ / far, 3)) / 3; });
        return std::sqrt(second / square(irradiance()) - 1);
    }

    /// What is seen in 2^15 directions, in 16 blocks.
    [[nodiscard]] Estimate deviation_seen(TriangleSampling triangles, std::uint64_t seed, int threads) const {
        const Emitters          emitters(lamp(), triangles);
        std::array<Running, 16> blocks;  // of irradiances
        for_each_row(blocks.size(), {.threads = threads}, [&](std::size_t block) {
            Rng rng{seed, std::int32_t(block), 0, 0};
            for (int i = 0; i < 2048; ++i) blocks[block].add(one(emitters, rng));
        });
        Running deviations;
        for (const Running& E : blocks) deviations.add(std::sqrt(E.variance()) / irradiance());
        return {deviations.mean(), deviations.standard_error()};
    }

    /// One estimate of the irradiance.
    [[nodiscard]] static double one(const Emitters& emitters, Rng& rng) {
        constexpr SurfacePoint<float> receiver{{0, 0, 0}, {0, 0, 1}, {}};
        const float                   x = rng.uniform(), y = rng.uniform();
        const auto                    light = emitters.sample(receiver, {x, y});
        return light ? double(light->direction.z * light->arriving.g) : 0;
    }

    [[nodiscard]] Scene lamp() const {
        Scene scene;
        scene.materials = {grey(0, 1)};
        add_quad(scene, {{{-1, -1, h_}, {1, -1, h_}, {1, 1, h_}, {-1, 1, h_}}}, 0);
        return scene;
    }

    [[nodiscard]] double irradiance() const {
        return over_angles([&](double far) { return (1 - square(h_ / far)) / 2; });
    }

private:
    /// Eight times the integral from 0 to 45 degrees of what depends on the distance of the square's edge.
    template <class F>
    [[nodiscard]] double over_angles(const F& f) const {
        double sum = 0;
        for (const auto& [angle, weight] : gauss_legendre(32, 0, std::numbers::pi / 4))
            sum += 8 * weight * f(std::hypot(h_, 1 / std::cos(angle)));
        return sum;
    }

    double h_;
};

}  // namespace sr
