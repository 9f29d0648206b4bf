/// @file main.cpp
/// Chapter 2, surfaces: what a ray meets when a surface is an equation.

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "along_a_ray.hpp"
#include "any_surface.hpp"
#include "course/chapter.hpp"
#include "far_sphere.hpp"
#include "geometry/plane.hpp"
#include "geometry/sphere.hpp"
#include "leaving.hpp"
#include "math/extremes.hpp"
#include "planet.hpp"
#include "textbook_sphere.hpp"

namespace sr {
namespace {

constexpr int rays = 100'000;  // whatever the quality: what is counted is in the text

/// 2.1  Where does a ray meet what an equation describes?
void surface_is_an_equation(course::Chapter& chapter) {
    chapter.section("2.1 A surface is an equation");
    auto diagram = chapter.diagram("along_a_ray", "A surface, and its function along a ray");
    draw_along_a_ray(diagram);
    diagram.caption(
        "Where $f$ changes its sign along the ray, the ray goes through the surface. The nearest $t \\ge 0$ "
        "counts.");
}

/// 2.2  And if the equation is linear?
void plane(course::Chapter& chapter) {
    chapter.section("2.2 The plane");
    const Plane<double> leaning{{1, 2, 2}, {1, 2, 2}};
    for (const auto& [how, direction, expected] :
         {std::tuple{"steep", Vector3<double>{1, 1, 1}, 1.8}, {"grazing", {2, -1, 1e-9}, 4.5e9}}) {
        const auto t = intersect(leaning, Ray<double>{{0, 0, 0}, direction});
        chapter.claim(fmt::format("2.2 t of the {} ray", how),
                      {.expected = expected, .measured = t ? *t : HUGE_VAL, .tolerance = 1e-14 * expected});
    }
}

void claim_wrong(course::Chapter& chapter, const course::Chart& wrong) {
    struct Printed {
        double distance, percent, last_digit;
    };
    const auto claim = [&](const std::string& series, const std::vector<Printed>& table) {
        for (const auto& [distance, percent, last_digit] : table) {
            chapter.claim(
                fmt::format("2.3 {}: wrong rays at {:.0e} radii [%]", series, distance),
                {.expected = percent, .measured = wrong.at(series, distance), .tolerance = last_digit / 2});
        }
    };
    claim("school, float",
          {{1e1, 0.002, 1e-3}, {1e3, 3.4, 0.1}, {1e5, 32.7, 0.1}, {1e7, 34.6, 0.1}, {1e9, 57.1, 0.1}});
    claim("cured, float", {{1e1, 0, 0}, {1e3, 0, 0}, {1e5, 0.11, 0.01}, {1e7, 30.5, 0.1}, {1e9, 25.1, 0.1}});
    claim("school, double", {{1e1, 0, 0}, {1e3, 0, 0}, {1e5, 0, 0}, {1e7, 0.95, 0.01}, {1e9, 34.7, 0.1}});
}

/// 2.3  How far away can a sphere be before the school formula loses it?
void sphere_at_a_distance(course::Chapter& chapter) {
    chapter.section("2.3 The sphere, and how the school formula loses it");
    const std::string x     = "distance [radii]";
    auto              wrong = chapter.chart(
                     "sphere_at_a_distance", "A unit sphere, seen from far away",
                     course::with_error({.x = x, .y = "wrong hits and misses [% of the rays]", .log = course::axis::xy}));
    auto       worst    = chapter.chart("sphere_t_error", "The same rays: how far off is a hit?",
                                        {.x = x, .y = "largest error of $t$ [radii]", .log = course::axis::xy});
    double     wrong_se = 0;
    const auto race     = [&]<class T>(const std::string& name, T, const auto& method) {
        for (double distance = 10; distance <= 1e9; distance *= 10) {
            const auto errors = far_sphere<T>(distance, rays, chapter.options().threads, method);
            wrong.add(name, distance, {errors.wrong, errors.wrong_se});
            worst.add(name, distance, errors.worst_t);
            wrong_se = max_or_nan(wrong_se, errors.wrong_se);
        }
    };
    const auto school = [](const auto& sphere, const auto& ray) { return textbook_crossings(sphere, ray); };
    const auto cured  = [](const auto& sphere, const auto& ray) { return crossings(sphere, ray); };
    race("school, float", 0.0F, school);
    race("cured, float", 0.0F, cured);
    race("school, double", 0.0, school);
    race("cured, double", 0.0, cured);
    wrong.caption(
        "The cure (2.5) buys three orders of magnitude of distance in float; in double it errs nowhere "
        "here.");
    worst.caption("An error of 1 is a radius: the hit may as well be on the other side.");

    claim_wrong(chapter, wrong);
    chapter.claim("2.3 the largest standard error of the wrong rays [%]",
                  {.expected = 0.16, .measured = wrong_se, .tolerance = 0.005});
    double worst_in_double = 0;
    for (double distance = 10; distance <= 1e9; distance *= 10)
        worst_in_double = max_or_nan(worst_in_double, wrong.at("cured, double", distance));
    chapter.claim("2.3 cured, double: wrong rays at the worst of the distances [%]",
                  {.measured = worst_in_double});
    chapter.claim("2.3 school, float: largest error of t at 1e4 radii [radii]",
                  {.expected = 5.5, .measured = worst.at("school, float", 1e4), .tolerance = 0.05});
    chapter.claim("2.3 cured, float: largest error of t at 1e4 radii [radii]",
                  {.expected = 0.015, .measured = worst.at("cured, float", 1e4), .tolerance = 0.0005});
}

/// 2.7  What is under somebody's feet who stands on a planet?
void standing_on_a_planet(course::Chapter& chapter) {
    chapter.section("2.7 Standing on a planet");
    auto chart = chapter.chart(
        "planet", "Looking down from a height of 1, in float",
        course::with_error(
            {.x = "radius of the planet", .y = "error of $t$ [% of $t$], median", .log = course::axis::xy}));
    const auto stand = [&](const std::string& name, Place place, const auto& method) {
        for (float radius = 10; radius <= 1e7F; radius *= 10)
            chart.add(name, radius,
                      median_error_on_planet(radius, place, rays / 5, chapter.options().threads, method));
    };
    const auto plain = [](const auto& sphere, const auto& ray) {
        return ground_below(sphere, ray, PlainConstant{});
    };
    const auto factored = [](const auto& sphere, const auto& ray) {
        return ground_below(sphere, ray, FactoredConstant{});
    };
    const auto cured = [](const auto& sphere, const auto& ray) { return crossings(sphere, ray)->first; };
    stand("school", Place::anywhere, ground_below_at_school);
    stand("(2.5), plain constant, anywhere", Place::anywhere, plain);
    stand("factored (2.15), anywhere", Place::anywhere, factored);
    stand("factored (2.15), at a pole", Place::pole, factored);
    stand("with all digits (2.16), anywhere", Place::anywhere, cured);
    chart.caption(
        "A length is rounded, too: factored, the constant term is right where one coordinate is the height.");

    for (const auto& [series, radius, expected, digit] :
         {std::tuple{"school", 1e5, 0.19, 0.01},
          {"school", 1e7, 19, 1},
          {"(2.5), plain constant, anywhere", 1e5, 0.15, 0.01},
          {"(2.5), plain constant, anywhere", 1e7, 14, 1},
          {"factored (2.15), anywhere", 1e5, 0.21, 0.01},
          {"factored (2.15), anywhere", 1e7, 26, 1}}) {
        chapter.claim(fmt::format("2.7 {}: median error of t at a radius of {:.0e} [%]", series, radius),
                      {.expected = expected, .measured = chart.at(series, radius), .tolerance = digit / 2});
    }
    for (const std::string series : {"factored (2.15), at a pole", "with all digits (2.16), anywhere"}) {
        double worst = 0;
        for (float radius = 10; radius <= 1e7F; radius *= 10)
            worst = max_or_nan(worst, chart.at(series, radius));
        chapter.claim_at_most(fmt::format("2.7 {}: median error of t, any radius [%]", series), worst, 1e-5);
    }
}

/// The curves of section 2.8, and where they have points.
const std::string         fixed  = "fixed epsilon, $10^{-4}$";
const std::string         scaled = "scaled epsilon, $2\\cdot10^{-5}\\,|\\mathbf{p}|$";
const std::string         bound  = "error bound";
const std::vector<double> radii{1e-5, 1e-4, 1e-3, 1e-2, 1e-1, 1, 1e1, 1e2, 1e3, 1e4, 1e5};

void claim_leaving(course::Chapter& chapter, const course::Chart& self, const course::Chart& lost) {
    const auto claim = [&](const std::string& what, double expected, double measured, double tolerance) {
        chapter.claim("2.8 " + what, {.expected = expected, .measured = measured, .tolerance = tolerance});
    };
    claim("fixed epsilon: self-hits at a radius of 100 [%]", 5.9, self.at(fixed, 1e2), 0.05);
    claim("fixed epsilon: self-hits at a radius of 10 000 [%]", 52, self.at(fixed, 1e4), 0.5);
    claim("fixed epsilon: lost hits at a radius of 0.0001 [%]", 50, lost.at(fixed, 1e-4), 1);
    claim("fixed epsilon: lost hits at a radius of 0.001 [%]", 5, lost.at(fixed, 1e-3), 0.5);
    double scaled_self = 0, scaled_lost = 0, bound_worst = 0;
    for (const double radius : radii) {
        scaled_self += 1e2 * self.at(scaled, radius) / double(radii.size());
        scaled_lost += 1e2 * lost.at(scaled, radius) / double(radii.size());
        bound_worst = max_or_nan(bound_worst, self.at(bound, radius) + lost.at(bound, radius));
    }
    claim("scaled epsilon: self-hits in 10 000 rays", 3, scaled_self, 0.5);
    claim("scaled epsilon: lost hits in 10 000 rays", 2, scaled_lost, 0.5);
    const auto of_scaled =
        leaving_errors(10, Spread::uniform, rays, chapter.options().threads, by_scaled_epsilon);
    claim("scaled epsilon: standard error of self-hits in 10 000 rays", 0.5, 1e2 * of_scaled.self_hits_se,
          0.05);
    claim("scaled epsilon: standard error of lost hits in 10 000 rays", 0.5, 1e2 * of_scaled.lost_se, 0.05);
    double no_epsilon_lost = 0;
    for (const double radius : radii)
        no_epsilon_lost +=
            1e2 / double(radii.size()) *
            leaving_errors(radius, Spread::uniform, rays, chapter.options().threads, by_no_epsilon).lost;
    claim("no epsilon: lost hits in 10 000 rays", 2, no_epsilon_lost, 0.5);
    claim("error bound: self-hits and lost hits at the worst of the radii [%]", 0, bound_worst, 0);
}

/// 2.8  Where does a ray start that leaves a surface?
void leaving_a_surface(course::Chapter& chapter) {
    chapter.section("2.8 Leaving a surface");
    const std::string x    = "radius of the sphere";
    auto              self = chapter.chart(
                     "leaving_self_hits", "Rays that leave a sphere outwards",
                     course::with_error({.x = x, .y = "rays that meet what they leave [%]", .log = course::axis::xy}));
    auto lost = chapter.chart(
        "leaving_lost_hits", "Rays that leave it inwards",
        course::with_error({.x = x, .y = "rays that miss the other side [%]", .log = course::axis::xy}));
    const auto launch = [&](const std::string& name, const auto& method) {
        for (const double radius : radii) {
            const auto errors =
                leaving_errors(radius, Spread::uniform, rays, chapter.options().threads, method);
            self.add(name, radius, {errors.self_hits, errors.self_hits_se});
            lost.add(name, radius, {errors.lost, errors.lost_se});
        }
    };
    launch(fixed, by_fixed_epsilon);
    launch(scaled, by_scaled_epsilon);
    launch(bound, by_error_bound);
    self.caption("Half of the points that rounding finds on a sphere lie inside it.");
    lost.caption("An epsilon skips the near end of short chords; a point outside lets grazing rays pass by.");
    claim_leaving(chapter, self, lost);
}

}  // namespace
}  // namespace sr

int main(int argc, char** argv) {
    using namespace sr;
    const course::Defaults defaults{
        .samples = course::ByQuality{4, 9, 9}, .square_samples = true, .takes_seed = false};
    return course::run(argc, argv, "02_surfaces", "Surfaces", defaults, [](course::Chapter& chapter) {
        surface_is_an_equation(chapter);
        plane(chapter);
        sphere_at_a_distance(chapter);
        any_surface(chapter);
        any_surface_speed(chapter);
        normals(chapter);
        standing_on_a_planet(chapter);
        leaving_a_surface(chapter);
    });
}
