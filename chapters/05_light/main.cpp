/// @file main.cpp
/// Chapter 5, light: what is measured of it, in which units, and what a lamp does to a surface.

#include <fmt/format.h>

#include <tuple>

#include "closed_forms.hpp"
#include "cosine_law_chart.hpp"
#include "course/chapter.hpp"
#include "distance_chart.hpp"
#include "distance_diagrams.hpp"
#include "eclipse.hpp"
#include "flux_diagram.hpp"
#include "lamps_chart.hpp"
#include "math/degrees.hpp"
#include "near_lamp_chart.hpp"
#include "radiance_diagrams.hpp"
#include "radiometry/photons.hpp"
#include "sampled.hpp"
#include "small_chart.hpp"
#include "solid_angle_diagrams.hpp"

namespace sr {
namespace {

/// 5.1  What does a lamp emit?
void flux(course::Chapter& chapter) {
    chapter.section("5.1 Flux");
    auto diagram = chapter.diagram("flux_density", "Flux, per area");
    draw_flux_density(diagram);
    diagram.caption("At a point there is no flux; but there is a limit of flux over area.");

    const Flux<double> watt{1};
    for (const auto& [colour, nm, expected] :
         {std::tuple{"green", 555.0, 2.79e18}, {"red", 650.0, 3.27e18}}) {
        const auto photons = photons_per_time(watt, Length<double>{nm * 1e-9});
        chapter.claim(fmt::format("5.1 photons in a watt of {} light, {} nm [1/s]", colour, nm),
                      {.expected = expected, .measured = photons.value(), .tolerance = 0.005e18});
    }
}

/// 5.2  How large does a thing look?
void solid_angles(course::Chapter& chapter) {
    chapter.section("5.2 Solid angle");
    auto finite = chapter.diagram("solid_angle", "Solid angle");
    draw_solid_angle(finite);
    finite.caption("The area of a cone's piece of a sphere grows as the square of the radius.");
    auto small = chapter.diagram("small_area", "The solid angle of a small area");
    draw_small_area(small);
    small.caption("Two things make an area look small: that it is far away, and that it is turned.");
    chart_small_areas(chapter);
}

/// 5.3  Which of the formulas can be computed?
void small_solid_angles(course::Chapter& chapter) {
    chapter.section("5.3 Small lamps");
    chart_rounding(chapter);
    claim_solid_angles(chapter);
    claim_cone(chapter);
}

/// 5.4  And if something is in the way?
void visibility(course::Chapter& chapter) {
    chapter.section("5.4 Visibility");
    auto diagram = chapter.diagram("visibility", "What is seen, and what is not");
    draw_visibility(diagram);
    diagram.caption("A point may be hidden by something else, or by the rest of its own surface.");

    auto chart = chapter.chart(
        "eclipse", "A lamp of angular radius 30 degrees, a ball of 20",
        course::with_error({.x = "angle between the centres [deg]", .y = "visible solid angle [sr]"}));
    const Eclipse eclipse;
    const int     threads = chapter.options().threads;
    for (int apart = 0; apart <= 60; apart += 2)
        chart.add("closed form", apart, Estimate{eclipse.visible(radians(apart))});
    for (int apart = 1; apart <= 60; apart += 2) {
        const auto rays = eclipse.visible_by_rays(radians(apart), {threads, 1 << 10, apart});
        chart.add("by rays", apart, estimate(rays));
    }
    chart.as_line("closed form");
    chart.as_points("by rays");
    chart.caption(
        "Rays into the lamp's cone, 65 536 for a point, each asked whether the ball is in its way.");

    const auto rays = eclipse.visible_by_rays(radians(25), {threads, 1 << 14});
    chapter.claim("5.4 visible at 25 degrees, closed form [sr]",
                  {.expected = 0.61865, .measured = eclipse.visible(radians(25)), .tolerance = 5e-6});
    chapter.claim("5.4 visible at 25 degrees, by a million rays [sr]",
                  {.expected = 0.619, .measured = rays.mean(), .tolerance = 0.002});
    chapter.claim("5.4 standard error of a million rays [sr]",
                  {.expected = 0.00036, .measured = rays.standard_error(), .tolerance = 5e-6});
}

/// 5.5  What does a direction add to it?
void radiance(course::Chapter& chapter) {
    chapter.section("5.5 Radiance, and Lambert's cosine law");
    auto cone = chapter.diagram("radiance", "Radiance");
    draw_radiance_cone(cone);
    cone.caption("Flux per area and solid angle; the area is that which the direction sees.");
    auto turned = chapter.diagram("orientation", "A surface that is turned gets less");
    draw_oriented_surfaces(turned);
    turned.caption("The flux is spread over a larger area. The light itself is the same.");

    chart_cosine_law(chapter);
}

/// 5.6  What is left of it at the other end?
void conservation(course::Chapter& chapter) {
    chapter.section("5.6 Radiance is conserved");
    auto diagram = chapter.diagram("two_patches", "Two patches that see each other");
    draw_two_patches(diagram);
    diagram.caption(
        "Each solid angle is the other patch, seen from here: the product is the same both ways.");
    claim_two_disks(chapter);

    auto square_law = chapter.diagram("inverse_square", "The inverse square law");
    draw_inverse_square(square_law);
    square_law.caption("The flux in the cone stays the same; the area that it falls on grows.");
    render_globes(chapter);
    chart_receding_sphere(chapter);
    claim_far_spheres(chapter);
    chart_nested_spheres(chapter);

    auto sensor = chapter.diagram("sensor", "Irradiance and radiance");
    draw_sensor(sensor);
    sensor.caption("Twice as far away, a surface gets a quarter; a pixel sees four times the area.");
}

}  // namespace
}  // namespace sr

int main(int argc, char** argv) {
    using namespace sr;
    const course::Defaults defaults{.takes_seed = false};
    return course::run(argc, argv, "05_light", "Light", defaults, [](course::Chapter& chapter) {
        flux(chapter);
        solid_angles(chapter);
        small_solid_angles(chapter);
        visibility(chapter);
        radiance(chapter);
        conservation(chapter);
        closed_forms(chapter);
        speed_against_accuracy(chapter);
    });
}
