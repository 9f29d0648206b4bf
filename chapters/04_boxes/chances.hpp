#pragma once
/// @file chances.hpp
/// Section 4.4: what lines from everywhere see of convex bodies, against what is known.

#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "chords.hpp"
#include "course/chapter.hpp"
#include "math/extremes.hpp"

namespace sr {

/// How far an estimate lies off, in its standard errors.
[[nodiscard]] inline double standard_errors_off(const Running& estimate, double expected) {
    return std::abs(estimate.mean() - expected) / estimate.standard_error();
}

/// Chords and shadows of five bodies, as a table. @return the worst deviation [standard errors]
[[nodiscard]] inline double measure_bodies(course::Chapter& chapter, const Draw& draw) {
    course::Rows table{
        {"body", "mean chord", "error", "4V/S", "l^4", "error", "12V^2/(pi S)", "shadow", "S/4"}};
    double worst = 0;
    for (const auto& body : {ball_body(1), box_body("cube", {1, 1, 1}), box_body("box 1 x 2 x 3", {1, 2, 3}),
                             tetrahedron_body(1), cylinder_body(1, 2)}) {
        const double v = body.volume, s = body.surface;
        const auto   chords = measure_chords(body, draw);
        const double chord = 4 * v / s, fourth = 12 * v * v / (std::numbers::pi * s);
        worst = max_or_nan(worst, standard_errors_off(chords.length, chord));
        worst = max_or_nan(worst, standard_errors_off(chords.fourth, fourth));
        table.add({body.name, chords.length.mean(), chords.length.standard_error(), chord,
                   chords.fourth.mean(), chords.fourth.standard_error(), fourth, mean_shadow(chords, body),
                   s / 4});
    }
    chapter.say(table);
    return worst;
}

/// A body in another one.
struct Nested {
    ConvexBody inner, outer;
};
[[nodiscard]] inline std::vector<Nested> nested_bodies() {
    const auto cube = box_body("cube", {1, 1, 1});
    return {{box_body("card", {0.02, 0.5, 0.5}), cube},
            {box_body("stick", {0.2, 0.2, 1}), cube},
            {box_body("small cube", {0.5, 0.5, 0.5}), cube},
            {box_body("sheet", {0.01, 1, 1}), cube},
            {ball_body(0.5), cube},
            {tetrahedron_body(1), cube},
            {cube, ball_body(std::numbers::sqrt3 / 2)},
            {box_body("slab", {0.6, 1, 1}), cube}};
}

/// The eye of figure 4.3, outside the cube [-1/2, 1/2]^3.
inline const Vector3<double> one_eye{0.9, 0.4, 0.3};

/// What figure 4.3 has of lines from everywhere: the shares by the inner body, and the worst deviation of them all.
struct Chances {
    std::map<std::string, Running> share;
    double                         worst = 0;  ///< [standard errors]
};

/// Figure 4.3: lines from everywhere on the diagonal, and a point for each body as the eye sees it.
[[nodiscard]] inline Chances chart_chances(course::Chapter& chapter, const Draw& draw) {
    auto chart = chapter.chart(
        "chances", "Lines that meet a body meet another one inside it",
        {.x       = "$S_{\\mathrm{inner}} / S_{\\mathrm{outer}}$",
         .y       = "share of lines",
         .columns = {.headers = {"series", "ratio", "share", "standard_error", "inner", "outer"},
                     .series  = "series",
                     .x       = "ratio",
                     .y       = "share",
                     .error   = "standard_error"}});
    Chances    chances;
    const auto add = [&](const std::string& series, const Nested& pair, const Running& met) {
        chart.row({series, pair.inner.surface / pair.outer.surface, met.mean(), met.standard_error(),
                   pair.inner.name, pair.outer.name});
    };
    for (const auto& pair : nested_bodies()) {
        const auto& [inner, outer] = pair;
        const auto met             = measure_nested(inner, outer, draw);
        const auto from_eye        = measure_nested(inner, outer, draw, one_eye);
        add("from everywhere", pair, met);
        add(outer.name == "ball" ? inner.name + " in a ball" : inner.name, pair, from_eye);
        chances.worst = max_or_nan(chances.worst, standard_errors_off(met, inner.surface / outer.surface));
        chances.share.emplace(inner.name, met);
    }
    chart.caption(
        "Lines from everywhere lie on the diagonal (4.8). The points with names: bodies in a cube, and the "
        "cube in a "
        "ball, as seen from one eye outside the cube. Bars of one standard error are smaller than the "
        "marks.");
    return chances;
}

}  // namespace sr
