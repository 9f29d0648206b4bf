#pragma once
/// @file optics_charts.hpp
/// The charts of section 7.7: where balls and hollow mirrors send light that comes parallel.

#include <cmath>
#include <string>

#include "course/chapter.hpp"
#include "math/degrees.hpp"
#include "optics.hpp"

namespace sr {

/// Indices of refraction of water for the ends of what the eye sees, 700 and 400 nm.
/// @see Hale and Querry, Optical Constants of Water in the 200-nm to 200-um Wavelength Region, Applied Optics 12 (1973)
inline constexpr double water_red    = 1.331;
inline constexpr double water_violet = 1.339;

/// The impact parameter at which a drop turns light least, and the angle to the sun's rays at which that comes back.
struct Bow {
    double b;
    double angle;  ///< [rad]
};
[[nodiscard]] inline Bow primary_bow(double n) {
    const auto   turned = [&](double b) { return deviation(*through_drop(b, n)); };
    const double b      = least_at(turned, 0.1, 0.99);
    return {b, std::numbers::pi - turned(b)};
}

/// The angle at which light comes back from a drop, against where it met the drop.
inline void chart_rainbow(course::Chart chart) {
    for (const auto& [name, n] :
         {std::pair{"violet, $n = 1.339$", water_violet}, {"red, $n = 1.331$", water_red}}) {
        for (int i = 0; i <= 99; i += 3) {
            const double b = 0.01 * i;
            chart.add(name, b, degrees(std::numbers::pi - deviation(*through_drop(b, n))));
        }
    }
}

/// How far from its focus light crosses the axis, against its distance from it, both in radii.
inline void chart_aberration(course::Chart chart) {
    constexpr double n = 1.5, ball_focus = n / (2 * (n - 1)), mirror_focus = 0.5;
    for (double h = 0.01; h < 0.9; h *= 1.25) {
        chart.add("ball of glass, before $f$", h, ball_focus - ball_lens_crossing(h, 1, n));
        chart.add("hollow mirror, behind $f$", h,
                  axis_crossing(off_hollow_mirror(h, 1).back()) - mirror_focus);
    }
}

}  // namespace sr
