#pragma once
/// @file any_surface.hpp
/// Sections 2.4 to 2.6: surfaces of any equation, ways to find where a ray meets them, and their normals.

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "course/chapter.hpp"
#include "gallery.hpp"
#include "math/angle.hpp"
#include "math/degrees.hpp"
#include "method_diagrams.hpp"
#include "methods_chart.hpp"
#include "normals_chart.hpp"
#include "squared_sphere.hpp"
#include "statistics/slope.hpp"
#include "steps_that_miss.hpp"

namespace sr {

/// The drawings of section 2.4.
inline void draw_methods(course::Chapter& chapter) {
    auto marching = chapter.diagram("marching", "Fixed steps, and what lies between two of them");
    draw_marching(marching);
    marching.caption("Outside on both sides of the near wall, inside once in the far one.");
    auto spheres = chapter.diagram("sphere_tracing", "Steps that can't go through the surface");
    draw_sphere_tracing(spheres);
    spheres.caption(
        "$f = |\\mathbf{p}|^2 - 1$ is no distance; divided by a Lipschitz bound it is never more than one.");
    auto intervals = chapter.diagram("intervals", "$f$ along a ray, and what intervals prove");
    IntervalPicture(intervals).draw();
    intervals.caption("Each box holds all values that $f$ may have on its piece of the ray.");
}

/// 2.4  Which share of true hits do fixed steps miss?
inline void steps_miss(course::Chapter& chapter) {
    const auto chart = chart_steps_that_miss(chapter);
    for (const auto& [step, percent, tolerance] :
         {std::tuple{1.0, 8.3, 0.05}, {0.5, 2.08, 0.005}, {0.1, 0.08, 0.005}}) {
        chapter.claim(fmt::format("2.4 chords of the unit sphere missed by steps of {} [%]", step),
                      {.expected  = percent,
                       .measured  = chart.at("unit sphere, counted", step),
                       .tolerance = tolerance});
    }
    for (const auto& [name, percent] :
         {std::pair{"wire of radius 0.01", 80.0}, {"wire of radius 0.001", 98.0}}) {
        chapter.claim(fmt::format("2.4 a {}, missed by steps of 0.1 [%]", name),
                      {.expected = percent, .measured = chart.at(name, 0.1), .tolerance = 0.5});
    }
}

/// 2.4  Where f is no distance, and where it changes no sign.
inline void steps_go_wrong(course::Chapter& chapter) {
    const LooseBounds<Ellipsoid<double>, double> sphere{{{1, 1, 1}}, 6};
    const Ray<double>                            axis{{-5, 0, 0}, {1, 0, 0}};
    double                                       t = 0;
    for (int i = 0; i < 2; ++i) t += on_ray(sphere, axis, t);
    chapter.claim("2.4 f taken for the distance, t after two steps", {.expected = 384, .measured = t});
    const double bound = lipschitz_bound(sphere, Box<double>{{-5, 0, 0}, {5, 0, 0}});
    chapter.claim("2.4 divided by its Lipschitz bound, the first step [length]",
                  {.expected = 2.4, .measured = on_ray(sphere, axis, 0.0) / bound, .tolerance = 0.05});
    const auto hit = sphere_trace(sphere, axis, in_front<double>, bound, 1e-9);
    chapter.claim("2.4 and where the steps arrive [length]",
                  {.expected = 4, .measured = hit.value_or(0), .tolerance = 1e-8});

    const Interval<double> whole{0, 8};
    chapter.claim("2.4 roots of a squared equation found by 100 000 steps",
                  {.expected = 0, .measured = march(SquaredSphere{}, axis, whole, 8e-5) ? 1.0 : 0.0});
    for (const auto& [method, root] :
         {std::pair{"intervals", bisect_intervals(SquaredSphere{}, axis, whole, 1e-9)},
          {"a quartic", solve(SquaredSphere{}, axis, whole)}}) {
        chapter.claim(fmt::format("2.4 its first root by {} [length]", method),
                      {.expected = 4, .measured = root.value_or(0), .tolerance = 1e-6});
    }
}

/// 2.4  What if f is no polynomial of degree two?
inline void any_surface(course::Chapter& chapter) {
    chapter.section("2.4 Any surface");
    portray_all(chapter);
    draw_methods(chapter);
    steps_miss(chapter);
    steps_go_wrong(chapter);
}

/// What a race measured; times are the machine's, and no claims.
inline void say_laps(course::Chapter& chapter, const std::vector<Lap>& laps) {
    course::Rows table{
        {"method", "effort", "missed [%]", "invented [%]", "wrong +- [%]", "t error", "ns for a ray"}};
    for (const auto& [method, score, seconds] : laps)
        table.add({method.name, method.effort, 100 * score.missed, 100 * score.invented,
                   percent(score.wrong).error, score.t_error.value, 1e9 * seconds});
    chapter.say(table);
}

/// 2.5  What the text says of the torus.
inline void claim_laps(course::Chapter& chapter, const std::vector<Lap>& laps) {
    const auto wrong = [&](const std::string& method, double effort, double expected, double tolerance) {
        chapter.claim(fmt::format("2.5 {}, {}: rays whose first root is wrong [%]", method, effort),
                      {.expected  = expected,
                       .measured  = percent(lap_of(laps, method, effort).score.wrong).value,
                       .tolerance = tolerance});
    };
    wrong("fixed steps", 0.5, 2.7, 0.05);
    wrong("fixed steps", 0.1, 0.09, 0.005);
    wrong("fixed steps", 0.02, 0, 0);
    wrong("sphere tracing", 1e-3, 0.84, 0.005);
    wrong("segment tracing", 1e-3, 0, 0);
    wrong("intervals", 0.1, 11, 0.5);
    wrong("intervals", 1e-5, 0, 0);
    wrong("isolated roots", 0, 0, 0);
    wrong("Ferrari", 0, 0.21, 0.005);

    const auto standard_error = [&](const std::string& method, double effort, double expected,
                                    double tolerance) {
        chapter.claim(fmt::format("2.5 {}, {}: standard error of the wrong rays [%]", method, effort),
                      {.expected  = expected,
                       .measured  = percent(lap_of(laps, method, effort).score.wrong).error,
                       .tolerance = tolerance});
    };
    standard_error("sphere tracing", 1e-3, 0.07, 0.005);
    standard_error("Ferrari", 0, 0.04, 0.005);
    standard_error("fixed steps", 0.1, 0.02, 0.005);
    standard_error("isolated roots", 0, 0.006, 5e-4);

    const auto t_error = [&](const std::string& method, double effort, double expected, double tolerance) {
        chapter.claim(fmt::format("2.5 {}, {}: median error of t [length]", method, effort),
                      {.expected  = expected,
                       .measured  = lap_of(laps, method, effort).score.t_error.value,
                       .tolerance = tolerance});
    };
    t_error("sphere tracing", 1e-3, 0.012, 5e-4);
    t_error("fixed steps", 1, 3e-7, 0.5e-7);
    t_error("isolated roots", 0, 3e-7, 0.5e-7);
    t_error("Ferrari", 0, 3e-5, 0.5e-5);
}

/// 2.5  What does it cost not to miss?
inline void any_surface_speed(course::Chapter& chapter) {
    chapter.section("2.5 Speed against accuracy");
    const auto& options = chapter.options();
    const auto  wrong   = "rays whose first root is wrong [%]";

    const Race torus(shown_torus<float>, shown_torus<double>, 1 << 14, options);
    const auto laps = run_race(torus, all_methods(shown_torus<float>), options.quality);
    auto       chart =
        chapter.chart("methods", "16 384 rays to a torus, in float", lap_axes("percent_wrong", wrong));
    chart_laps(chart, laps);
    chart.caption("Along a curve the step or the tolerance shrinks.");
    auto t_chart = chapter.chart("methods_t", "The same rays: how well a root is known that is found",
                                 lap_axes("t_error", "median error of $t$ [length]"));
    chart_laps(t_chart, laps);
    t_chart.caption("Whoever brackets a root knows it to the last digits, whatever the step.");
    say_laps(chapter, laps);
    chapter.claim("2.5 rays to the torus", {.expected = 16'384, .measured = double(torus.rays().size())});
    claim_laps(chapter, laps);

    const Race balls(shown_metaballs<float>(), shown_metaballs<double>(), 1 << 12, options);
    const auto ball_laps  = run_race(balls, all_methods(shown_metaballs<float>()), options.quality);
    auto       ball_chart = chapter.chart("methods_metaballs", "4096 rays to five metaballs, in float",
                                          lap_axes("percent_wrong", wrong));
    chart_laps(ball_chart, ball_laps);
    ball_chart.caption("No polynomial, hence no quartic; and each value of $f$ is dear.");
    say_laps(chapter, ball_laps);
}

/// 2.6  Which way does a surface face?
inline void normals(course::Chapter& chapter) {
    chapter.section("2.6 Normals");
    const auto chart = chart_normals(chapter);
    chart_normals_speed(chapter);
    const auto claim = [&](const std::string& what, const std::string& curve, double h, double expected,
                           double tolerance) {
        chapter.claim(fmt::format("2.6 {}, mean angle [deg]", what),
                      {.expected = expected, .measured = chart.at(curve, h), .tolerance = tolerance});
    };
    claim("differences in float over 0.01", "differences, float", half_decade(-4), 0.0024, 5e-5);
    claim("differences in float over 0.0001", "differences, float", half_decade(-8), 0.14, 5e-3);
    claim("differences in double over 0.00001", "differences, double", half_decade(-10), 3.3e-9, 5e-11);
    claim("dual numbers in float", "dual numbers, float", half_decade(-4), 6.2e-6, 5e-8);
    claim("the gradient by hand in float", "by hand, float", half_decade(-4), 6.3e-6, 5e-8);
    chapter.claim_at_most("2.6 dual numbers in double, mean angle [deg]",
                          chart.at("dual numbers, double", half_decade(-4)), 1e-13);

    const auto power = [&](int from, int to) {
        std::vector<double> h, angle;
        for (int i = from; i <= to; ++i) {
            h.push_back(half_decade(i));
            angle.push_back(chart.at("differences, double", h.back()));
        }
        return log_log_slope(h, angle).value;
    };
    chapter.claim("2.6 the angle of wide differences grows with the power of h",
                  {.expected = 2, .measured = power(-8, -2), .tolerance = 0.05});
    chapter.claim("2.6 that of narrow ones with the power of 1/h",
                  {.expected = 1, .measured = -power(-24, -12), .tolerance = 0.05});

    // On the squared equation's surface the gradient is 0: the textbook's quotient is NaN, ours faces the viewer.
    const Vector3<double> pole{0, 0, 1}, d{0.6, 0, -0.8};
    chapter.claim("2.6 length of a squared equation's gradient on its surface",
                  {.expected = 0, .measured = length(gradient(SquaredSphere{}, pole))});
    chapter.claim("2.6 angle between the viewer and what stands for its normal [deg]",
                  {.expected = 0, .measured = degrees(angle_between(normal(SquaredSphere{}, pole, d), -d))});
}

}  // namespace sr
