#pragma once
/// @file closed_forms.hpp
/// Section 5.7: irradiance without an integral.

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "course/chapter.hpp"
#include "geometry/disk.hpp"
#include "math/degrees.hpp"
#include "radiometry/emitters.hpp"
#include "radiometry/projected_solid_angle.hpp"
#include "radiometry/sky.hpp"
#include "sampled.hpp"
#include "setting_lamp.hpp"

namespace sr {

/// What each lamp gives, in numbers that can be checked by hand; radiance 1, or 100 W.
inline void claim_lamps(course::Chapter& chapter) {
    const auto claim = [&](const std::string& what, double expected, double measured, double tolerance) {
        chapter.claim("5.7 " + what, {.expected = expected, .measured = measured, .tolerance = tolerance});
    };
    const auto I = Flux<double>{100} / SolidAngle<double>{4 * std::numbers::pi};
    claim("a point of 100 W, 2 above [W/m^2]", 1.9894, point_irradiance(I, 1.0, Length<double>{2}).value(),
          5e-5);
    claim("a sphere at twice its radius [W/m^2]", 0.7854,
          projected_solid_angle(Sphere<double>{{0, 0, 2}, 1}).value(), 5e-5);
    claim("a disk as high as its radius [W/m^2]", 1.5708,
          projected_solid_angle(Disk<double>{{0, 0, 1}, {0, 0, -1}, 1}).value(), 5e-5);
    claim("the same from below its rim [W/m^2]", 0.8683,
          projected_solid_angle(Disk<double>{{1, 0, 1}, {0, 0, -1}, 1}).value(), 5e-5);
    const std::vector<Vector3<double>> square{{-0.5, -0.5, 1}, {0.5, -0.5, 1}, {0.5, 0.5, 1}, {-0.5, 0.5, 1}};
    claim("a unit square at the height 1 [W/m^2]", 0.7523, projected_solid_angle(square).value(), 5e-5);
    const std::vector<Vector3<double>> wall{{1, -0.5, -1}, {1, 0.5, -1}, {1, 0.5, 1}, {1, -0.5, 1}};
    claim("a wall, half of it below the horizon [W/m^2]", 0.223, projected_solid_angle(wall).value(), 5e-4);
    const Radiance<double> L{1};
    claim("a uniform sky, level [W/m^2]", 3.1416, uniform_sky_irradiance(L, 0.0).value(), 5e-5);
    claim("an overcast sky, level [W/m^2]", 2.44346, overcast_sky_irradiance(L, 0.0).value(), 5e-6);
    claim("an overcast sky, upright over level", 0.396,
          overcast_sky_irradiance(L, radians(90)) / overcast_sky_irradiance(L, 0.0), 5e-4);
}

/// Figure 5.17: a lamp that sets.
inline void chart_setting_lamp(course::Chapter& chapter) {
    auto chart =
        chapter.chart("setting_lamp", "A spherical lamp of angular radius 30 degrees sets",
                      course::with_error({.x = "angle between the normal and the lamp's centre [deg]",
                                          .y = "irradiance [W/m$^2$]"}));
    const SettingLamp lamp;
    for (int beta = 0; beta <= 125; beta += 5) {
        chart.add("(5.16), (5.17)", beta, Estimate{lamp.irradiance(radians(beta))});
        chart.add("as a point light", beta, Estimate{lamp.as_a_point(radians(beta))});
    }
    for (double beta = 2.5; beta <= 120; beta += 5) {
        const auto rays = lamp.by_rays(radians(beta), {chapter.options().threads, 1 << 6, int(beta)});
        chart.add("by 4096 rays", beta, estimate(rays));
    }
    chart.as_line("(5.16), (5.17)");
    chart.as_line("as a point light");
    chart.as_points("by 4096 rays");
    chart.mark_x(60, "it begins to set");
    chart.caption(
        "Above the horizon, a sphere is a point light, exactly. At 90 degrees, half of it still shines.");
    chapter.claim("5.7 half set: irradiance [W/m^2]",
                  {.expected = 0.0906, .measured = lamp.irradiance(radians(90)), .tolerance = 5e-5});
    const auto rays = lamp.by_rays(radians(90), {chapter.options().threads, 1 << 14});
    chapter.claim("5.7 half set: irradiance by a million rays [W/m^2]",
                  {.expected = 0.0906, .measured = rays.mean(), .tolerance = 0.0006});
}

/// Figure 5.18: facets under two skies.
inline void chart_skies(course::Chapter& chapter) {
    const Radiance<double> L{1};
    auto                   chart =
        chapter.chart("skies", "A facet under the sky, black ground",
                      {.x = "tilt of the facet [deg]", .y = "irradiance, relative to a level facet"});
    for (int tilt = 0; tilt <= 180; tilt += 6) {
        const double a = radians(tilt);
        chart.add("uniform", tilt, uniform_sky_irradiance(L, a) / uniform_sky_irradiance(L, 0.0));
        chart.add("overcast", tilt, overcast_sky_irradiance(L, a) / overcast_sky_irradiance(L, 0.0));
    }
    chart.caption("The overcast sky is three times as bright at the zenith as at the horizon.");
}

inline void closed_forms(course::Chapter& chapter) {
    chapter.section("5.7 Irradiance in closed form");
    claim_lamps(chapter);
    chart_setting_lamp(chapter);
    chart_skies(chapter);
}

}  // namespace sr
