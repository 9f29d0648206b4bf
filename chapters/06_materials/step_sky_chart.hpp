#pragma once
/// @file step_sky_chart.hpp

#include <string>

#include "course/chapter.hpp"
#include "material/diffuse.hpp"
#include "material/mirror.hpp"
#include "material/phong.hpp"
#include "reflected.hpp"
#include "skies.hpp"

namespace sr {

/// What surfaces of albedo 1 show of a sky that is bright in one half, along the views that cross the step.
inline void chart_step_sky(course::Chapter& chapter, const HemisphereRule& rule) {
    auto       chart = chapter.chart("step_sky", "A sky of two halves, as seen in a surface",
                                     {.x = "angle of view [deg]", .y = "radiance that leaves [that of the sky]"});
    const auto curve = [&](const std::string& name, const auto& lobe) {
        for (int theta = -87; theta <= 87; theta += 3)
            if (theta != 0) chart.add(name, theta, reflected(lobe, StepSky{}, at_angle(theta), rule));
    };
    curve("diffuse", Diffuse<double>{});
    curve("Phong, $e = 10$", Phong{10.0});
    curve("Phong, $e = 100$", Phong{100.0});
    curve("mirror", Mirror<double>{});
    chart.caption("Views from the left mirror the bright half. A lobe blurs the step by its width.");
}

}  // namespace sr
