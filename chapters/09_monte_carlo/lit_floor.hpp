#pragma once
/// @file lit_floor.hpp
/// A floor below a square lamp, and square plates between them.

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "math/vector.hpp"
#include "radiometry/projected_solid_angle.hpp"
#include "sampling/spherical_rectangle.hpp"

namespace sr {

/// A level square of side 2 `half`, whose shadow lies around `shadow` on the floor.
struct Plate {
    Vector2<double> shadow;
    double          half;
    double          height;
};

/// A point of a floor of 4 x 4 below the middle of a lamp of radiance 1: side 1, height 2. Over it are three plates,
/// the lower the sharper their shadows. No point has two of them between itself and the lamp, so that its irradiance is
/// known.
class FloorPoint {
public:
    /// @param at  from -2 to 2 in both
    explicit FloorPoint(Vector2<double> at) : at_{at}, seen_{low(), high(), lamp_height} {}

    /// One estimate of the irradiance: a direction to the lamp, uniform in solid angle, and whether a plate is in its
    /// way.
    [[nodiscard]] double sample(Vector2<double> u) const {
        const auto w = seen_.sample(u);
        return std::ranges::any_of(plates, [&](const Plate& plate) { return hides(plate, w); })
                   ? 0
                   : w.z / length(w) * seen_.solid_angle();
    }

    /// No sample is more: that of a lamp that is seen whole, and all of it overhead.
    [[nodiscard]] double most() const { return seen_.solid_angle(); }

    /// The lamp's, less that of what the plates hide of it, equation (5.19).
    [[nodiscard]] double exact() const {
        double E = irradiance(low(), high());
        for (const Plate& plate : plates) {
            const auto [middle, half]  = hidden_by(plate);
            const Vector2<double> from = max(low(), middle - half), to = min(high(), middle + half);
            if (from.x < to.x && from.y < to.y) E -= irradiance(from, to);
        }
        return E;
    }

private:
    static constexpr double               lamp_height = 2, lamp_half = 0.5;
    static constexpr std::array<Plate, 3> plates{
        {{{-0.85, 0.85}, 0.35, 0.6}, {{0.95, 0.75}, 0.35, 0.3}, {{0.3, -1.05}, 0.35, 0.1}}};

    // of the lamp, as seen from here
    [[nodiscard]] Vector2<double> low() const { return -lamp_half - at_; }
    [[nodiscard]] Vector2<double> high() const { return lamp_half - at_; }

    /// The part of the lamp's plane that a plate hides from here: its middle, and half its side.
    struct Hidden {
        Vector2<double> middle;
        double          half;
    };
    [[nodiscard]] Hidden hidden_by(const Plate& plate) const {
        const double share  = plate.height / lamp_height;
        const auto   centre = (1 - share) * plate.shadow;  // of the plate
        return {(centre - at_) / share, plate.half / share};
    }
    [[nodiscard]] bool hides(const Plate& plate, const Vector3<double>& point) const {
        const auto [middle, half] = hidden_by(plate);
        return std::abs(point.x - middle.x) < half && std::abs(point.y - middle.y) < half;
    }
    [[nodiscard]] static double irradiance(Vector2<double> from, Vector2<double> to) {
        const std::vector<Vector3<double>> corners{
            {from, lamp_height}, {to.x, from.y, lamp_height}, {to, lamp_height}, {from.x, to.y, lamp_height}};
        return projected_solid_angle(corners).value();
    }

    Vector2<double>            at_;
    SphericalRectangle<double> seen_;
};

/// That in the middle of a pixel of a square picture, seen from above.
[[nodiscard]] inline FloorPoint floor_at(int x, int y, int size) {
    return FloorPoint{{4 * (x + 0.5) / size - 2, 2 - 4 * (y + 0.5) / size}};
}

}  // namespace sr
