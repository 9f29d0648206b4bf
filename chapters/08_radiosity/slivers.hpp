#pragma once
/// @file slivers.hpp
/// Section 8.9: faces that are narrower and narrower, up to those that have no area.

#include <cmath>
#include <optional>

#include "course/chapter.hpp"
#include "geometry/triangle.hpp"
#include "math/extremes.hpp"
#include "math/frame.hpp"
#include "radiosity/point_form_factors.hpp"
#include "sampling/ball.hpp"

namespace sr {

/// A triangle 1 long, turned in any way and 100 from the origin, where corners are rounded as in a file of that size.
/// It sees a unit square under 45 degrees, at the distance 1.
struct Sliver {
    Frame<double>   frame;   ///< along the triangle, across it, and its normal
    Vector3<double> centre;  ///< of gravity

    /// None if it is so narrow that its corners have rounded to a line.
    [[nodiscard]] std::optional<Patch> of_width(double width) const {
        const auto at = [&](double s, double t) { return centre + frame.to_world({s, width * t, 0}); };
        const Triangle<double> triangle{at(-0.5, -1.0 / 3), at(0.5, -1.0 / 3), at(0, 2.0 / 3)};
        if (!(area(triangle) > 0)) return std::nullopt;
        return Patch{triangle.a, triangle.b, triangle.c};
    }

    [[nodiscard]] Patch square_in_sight() const {
        const auto at = [&](double s, double t) {
            return centre + frame.to_world({s, std::sqrt(0.5) * (1 - t), std::sqrt(0.5) * (1 + t)});
        };
        return {at(-0.5, -0.5), at(0.5, -0.5), at(0.5, 0.5), at(-0.5, 0.5)};
    }

    /// By how much the form factor to the square is wrong, as a share of itself; none if there is no area.
    [[nodiscard]] std::optional<double> error(double width) const {
        const auto sliver = of_width(width);
        if (!sliver) return std::nullopt;
        const Patch there = square_in_sight();
        return std::abs(contour_form_factor(sliver->centre(), sliver->normal(), there) /
                            contour_form_factor(centre, frame.n, there) -
                        1);
    }
};

/// The k-th of slivers that lie and look anywhere.
[[nodiscard]] inline Sliver any_sliver(int k) {
    Rng                   rng{92, k, 0, 0};
    const Vector3<double> centre = 100.0 * normalize(in_unit_ball<double>(rng));
    return {frame_around(normalize(in_unit_ball<double>(rng))), centre};
}

/// What is wrong with 200 slivers of one width.
struct SliverErrors {
    double worst   = 0;  ///< error of a form factor, of those that have an area, as a share of itself
    double no_area = 0;  ///< the share of those that have none
};

[[nodiscard]] inline SliverErrors sliver_errors(double width) {
    constexpr int count = 200;
    SliverErrors  errors;
    for (int k = 0; k < count; ++k) {
        const auto error = any_sliver(k).error(width);
        if (error)
            errors.worst = max_or_nan(errors.worst, *error);
        else
            errors.no_area += 1.0 / count;
    }
    return errors;
}

/// The figure of section 8.9, and what the text says of one width.
inline void chart_slivers(course::Chapter& chapter) {
    auto chart = chapter.chart("slivers", "Slivers, 1 long, about 100 from the origin",
                               {.x = "width", .y = "relative error, or share", .log = course::axis::xy});
    for (int i = -31; i <= -8; ++i) {
        const double width  = std::pow(10.0, i / 2.0);
        const auto   errors = sliver_errors(width);
        chart.add("form factor, relative error", width, errors.worst);
        chart.add("light that is wrong / light of a unit square", width, width / 2 * errors.worst);
        chart.add("no area, share", width, errors.no_area);
        if (i >= -28) chart.add("$100 \\cdot 2^{-53}$ / width", width, 100 * std::ldexp(1.0, -53) / width);
    }
    chart.as_line("$100 \\cdot 2^{-53}$ / width");
    chart.mark_x(std::ldexp(1.0, -46), "spacing of doubles near 100");
    chart.caption("The worst of 200 that lie and look anywhere, of those that have an area.");
    const double worst = sliver_errors(1e-12).worst;
    chapter.claim("8.9 of slivers 1e-12 wide, the form factor is wrong by up to [%]",
                  {0.87, 100 * worst, 0.005});
    chapter.claim("8.9 the same of their light, as a share of a square's",
                  {4.4e-15, 1e-12 / 2 * worst, 0.05e-15});
}

}  // namespace sr
