#pragma once
/// @file lobe_plots.hpp
/// Lobes in the plane of incidence: f(wo, wi) as the distance from the point that is lit, in the direction wi.

#include <cmath>
#include <string>
#include <vector>

#include "course/chapter.hpp"
#include "math/degrees.hpp"
#include "reflected.hpp"

namespace sr {

/// The point so far from the origin, at an angle [degrees] to the upright.
[[nodiscard]] inline course::Point toward(double angle, double r) {
    return r * course::Point{std::sin(radians(angle)), std::cos(radians(angle))};
}

/// A surface, its normal, the direction in which it is seen, and that direction's mirror image.
inline void draw_seen(course::Diagram diagram, course::Point at, double half_width, double reach,
                      double theta) {
    using course::Ink;
    diagram.polygon(
        {at + course::Point{-half_width, 0}, at + course::Point{half_width, 0},
         at + course::Point{half_width, -0.07 * reach}, at + course::Point{-half_width, -0.07 * reach}},
        {Ink::grey, course::Weight::thin}, 0.35);
    diagram.arrow(at, at + toward(0, 0.85 * reach), {Ink::grey});
    diagram.label(at + toward(0, 0.95 * reach), "$\\mathbf{n}$", course::Anchor::centre, Ink::grey);
    diagram.arrow(at, at + toward(-theta, reach));
    diagram.label(at + toward(-theta, 1.12 * reach), "$\\omega_o$", course::Anchor::centre);
    diagram.line(at, at + toward(theta, reach), {Ink::grey, course::Weight::thin, true});
    diagram.label(at + toward(theta, 1.08 * reach), "$\\mathbf{r}$", course::Anchor::centre, Ink::grey);
}

/// The outline of a lobe that is seen from the left.
/// @param f  (angle of wi in degrees, to the right) -> value [1/sr], drawn with `scale`
template <class F>
void draw_lobe(course::Diagram diagram, course::Point at, course::Ink ink, double scale, const F& f,
               double from = -90, double to = 90) {
    std::vector<course::Point> outline{at};
    for (double angle = from; angle <= to; angle += 0.5)
        outline.push_back(at + toward(angle, scale * f(angle)));
    diagram.polygon(outline, {ink}, 0.2);
}

}  // namespace sr
