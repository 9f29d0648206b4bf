#pragma once
/// @file optics_claims.hpp
/// What sections 7.6 and 7.7 say of glass and water, traced.

#include <string>

#include "course/chapter.hpp"
#include "math/degrees.hpp"
#include "optics.hpp"
#include "optics_charts.hpp"

namespace sr {

/// @param symmetric  the angle of incidence at which the way through the prism is [rad]
inline void claim_flat_faces(course::Chapter& chapter, const Prism& prism, double symmetric) {
    const auto claim = [&](const std::string& what, double expected, double measured, double digit) {
        chapter.claim("7.6 " + what, {expected, measured, digit / 2});
    };
    claim("critical angle of glass [deg]", 41.81031, degrees(critical_angle(1.5)), 1e-5);
    claim("Snell's window in water [deg]", 97.18076, 2 * degrees(critical_angle(4.0 / 3)), 1e-5);
    claim("Brewster's angle of glass [deg]", 56.30993, degrees(right_angle_at(1.5)), 1e-5);
    claim("apparent depth, from above", 0.75, apparent_depth(1e-6, 4.0 / 3), 1e-9);
    claim("apparent depth, seen at 60 degrees", 0.493197, apparent_depth(radians(60), 4.0 / 3), 1e-6);
    claim("a plate's offset at 45 degrees", 0.329142, plate_offset(radians(45), 1.5), 1e-6);
    claim("angle of incidence at which a prism turns light least [deg]", 48.59038, degrees(symmetric), 1e-5);
    claim("by how much a prism turns light, at least [deg]", 37.18076,
          degrees(deviation(*prism.trace(symmetric))), 1e-5);
}

inline void claim_round_faces(course::Chapter& chapter) {
    const auto claim = [&](const std::string& what, double expected, double measured, double digit) {
        chapter.claim("7.7 " + what, {expected, measured, digit / 2});
    };
    claim("focus of a ball of glass, from its centre [radii]", 1.5, ball_lens_crossing(1e-5, 1, 1.5), 1e-8);
    claim("where light at half a radius from the axis crosses it [radii]", 1.3916,
          ball_lens_crossing(0.5, 1, 1.5), 1e-4);
    claim("focus of a hollow mirror, from its centre [radii]", 0.5,
          axis_crossing(off_hollow_mirror(1e-5, 1).back()), 1e-9);
    claim("where light at half a radius crosses behind a mirror [radii]", 0.57735,
          axis_crossing(off_hollow_mirror(0.5, 1).back()), 1e-5);
    claim("the rainbow's angle [deg]", 42.02966, degrees(primary_bow(4.0 / 3).angle), 1e-5);
    claim("the rainbow's distance from a drop's axis [radii]", 0.860663, primary_bow(4.0 / 3).b, 1e-6);
    claim("the rainbow's angle, red [deg]", 42.4, degrees(primary_bow(water_red).angle), 0.1);
    claim("the rainbow's angle, violet [deg]", 41.2, degrees(primary_bow(water_violet).angle), 0.1);
}

}  // namespace sr
