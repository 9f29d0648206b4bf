#pragma once
/// @file border_chart.hpp

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "course/chapter.hpp"
#include "material/phong_albedo.hpp"
#include "math/bracketed_root.hpp"
#include "math/degrees.hpp"

namespace sr {

/// For each exponent, the reflectance with which Phong's lobe as it is has an albedo of 1, seen under four angles.
inline void chart_border(course::Chapter& chapter) {
    auto chart =
        chapter.chart("border", "Above a curve, $\\rho\\,\\max(0, \\mathbf{r}\\cdot\\omega_i)^e$ makes light",
                      {.x = "exponent $e$", .y = "reflectance $\\rho$"});
    for (const double theta : {0.0, 45.0, 60.0, 75.0}) {
        const auto   excess = [&](double e) { return phong_albedo(e, radians(theta)) - 1; };
        const double last   = bracketed_root(excess, Interval<double>{0, 6}).value();
        for (int i = 0; i <= 12; ++i) {
            const double e = last * i / 12;
            // a root's last digit must not end the curve above 1
            chart.add(fmt::format("{} deg", theta), e, std::min(1.0, 1 / phong_albedo(e, radians(theta))));
        }
    }
    chart.mark_x(2 * std::numbers::pi - 2, "$2\\pi - 2$");
    chart.caption(
        "For four angles of incidence. The normal one is worst: its border is the straight line (6.15).");
}

}  // namespace sr
