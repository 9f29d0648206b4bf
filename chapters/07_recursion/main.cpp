/// @file main.cpp
/// Chapter 7, recursion: what a mirror shows is asked again, by a ray that starts at the mirror.

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "border.hpp"
#include "bounces_charts.hpp"
#include "boxes.hpp"
#include "course/chapter.hpp"
#include "furnace.hpp"
#include "glass_pictures.hpp"
#include "math/degrees.hpp"
#include "math/extremes.hpp"
#include "optics_charts.hpp"
#include "optics_claims.hpp"
#include "optics_diagrams.hpp"
#include "picture.hpp"
#include "plates_chart.hpp"
#include "quality_chart.hpp"
#include "tree_diagram.hpp"

namespace sr {
namespace {

/// The scene of --scene.
std::optional<SceneView> own_scene(course::Chapter& chapter) {
    const auto& options = chapter.options();
    if (!options.scene) return std::nullopt;
    return lit_view_of_file(*options.scene, options.size, [&](std::string_view line) { chapter.note(line); });
}

/// 7.1  What is seen in a mirror, and in glass?
/// @param own  scene, of the person who asks, in place of ours
void what_is_seen(course::Chapter& chapter, const std::optional<SceneView>& own) {
    chapter.section("7.1 What is seen in a mirror");
    auto diagram = chapter.diagram("tree", "The rays of one pixel");
    TreeDrawing(diagram).draw();
    diagram.caption(
        "Orange is reflected, green refracted. Paint ends a branch, and asks whether it sees the light.");

    const auto&      options = chapter.options();
    course::Progress progress("tracing rays up to 16 deep", steps_of_picture);
    if (own) {
        chapter.render("scene", "The scene",
                       "Rays up to 16 deep; its lamps, or one in their place, are points.",
                       picture(*own, {.depth = 16}, options, progress));
    } else {
        chapter.render("balls", "The Cornell box with a ball of mirror and one of glass",
                       "Rays up to 16 deep; the light is a point below the lamp.",
                       picture(box_with_balls(options.size), {.depth = 16}, options, progress));
    }
}

/// 7.2  What does recursion cost where there is nothing to recur on?
void cost_of_recursion(course::Chapter& chapter) {
    chapter.section("7.2 One function that calls itself");
    constexpr int side = 256;  // whatever the pictures' size: these numbers are in the text
    course::Rows  table{{"scene", "depth", "rays a pixel", "shadow rays a pixel"}};
    const auto    count = [&](const std::string& name, const SceneView& view, int depth, double rays,
                           double shadows) {
        const auto counted = count_rays(view, {.depth = depth}, chapter.options().threads);
        const auto a_pixel = [&](std::uint64_t n) { return double(n) / (side * side); };
        table.add({name, depth, a_pixel(counted.rays), a_pixel(counted.shadow_rays)});
        const auto which = fmt::format("7.2 {}, depth {}: ", name, depth);
        chapter.claim(which + "rays a pixel", {rays, a_pixel(counted.rays), 5e-3});
        chapter.claim(which + "shadow rays a pixel", {shadows, a_pixel(counted.shadow_rays), 5e-3});
    };
    for (const int depth : {1, 32}) count("paint", box_of_paint(side), depth, 1, 0.85);
    for (const auto& [depth, rays, shadows] :
         {std::tuple{1, 1.0, 0.82}, {2, 1.17, 0.91}, {4, 1.41, 0.98}, {8, 1.90, 1.17}, {32, 4.97, 2.26}})
        count("two balls", box_with_balls(side), depth, rays, shadows);
    chapter.say(table);
}

/// 7.3  How deep must rays go?
void how_deep(course::Chapter& chapter) {
    chapter.section("7.3 How deep?");
    const auto&      options = chapter.options();
    course::Progress progress("tracing rays of all depths", 6 * steps_of_picture);
    const auto       shown = [&](int depth) {
        return picture(box_with_balls(options.size / 2), {.depth = depth}, options, progress);
    };
    const auto deep = shown(16);
    for (const int depth : {1, 2, 3, 4, 6}) {
        const auto film = shown(depth);
        chapter.render(fmt::format("depth_{}", depth), fmt::format("Rays up to {} deep", depth),
                       "What a ray would have to ask further is black.", film);
        chapter.render(fmt::format("lacking_{}", depth), fmt::format("What depth {} lacks of 16", depth),
                       "Ten times as bright.", lacking(film, deep));
    }
    auto chart =
        chapter.chart("furnace", "Inside a mirror that shines",
                      {.x = "depth of the rays", .y = "light that is missing [%]", .log = course::axis::y});
    chart_furnace(chart);
    chart.caption("Each bounce leaves a share of $\\rho$ of what is missing, (7.7).");
    for (const auto& [k, L] : {std::pair{1, 1.0}, {5, 1.9375}, {10, 1.998046875}})
        chapter.claim(fmt::format("7.3 a mirror of 0.5 that shines, depth {}: radiance", k),
                      {L, in_furnace(0.5, k), 1e-6});
    chapter.claim("7.3 a mirror of 0.8 that shines, depth 100: radiance", {5, in_furnace(0.8, 100), 1e-5});
    for (const auto& [rho, rays] : {std::pair{0.5, 7}, {0.8, 21}, {0.95, 90}})
        chapter.claim(fmt::format("7.3 a mirror of {}: depth for 99 % of the light", rho),
                      {double(rays), double(depth_for_99_percent(rho)), 0});
}

/// 7.4  What does a tree of rays cost?
void tree_of_rays(course::Chapter& chapter) {
    chapter.section("7.4 The tree of rays");
    auto chart = chapter.chart("plates", "What four plates of glass let through", plates_axes());
    chart_plates(chart);
    chart.caption("Of random branches, the standard error. Numbers are counted, not timed.");

    const double exact = transmittance(plates_in_pile, 0.04);
    chapter.claim("7.4 four plates let through", {0.75, exact, 1e-12});
    const auto claim = [&](const std::string& what, const RecursionOptions& options, double rays,
                           double error, double digit) {
        const auto seen = look_through_plates(plates_in_pile, options);
        chapter.claim("7.4 " + what + ": rays", {rays, double(seen.rays), 0});
        chapter.claim("7.4 " + what + ": error", {error, std::abs(seen.radiance.mean() - exact), digit / 2});
    };
    claim("all branches, depth 9", {.depth = 9}, 157, 0.0286, 1e-4);
    claim("all branches, depth 17", {.depth = 17}, 23'721, 0.0054, 1e-4);
    claim("all branches, depth 19", {.depth = 19}, 83'803, 0.0027, 1e-4);
    claim("cut off at 0.0003", {.depth = 1000, .cut_off = 3e-4F}, 213, 0.0009, 1e-4);
    const auto random =
        look_through_plates(plates_in_pile, {.depth = 1000, .branching = Branching::random}, 10'000);
    const double se = random.radiance.standard_error();
    chapter.claim("7.4 one branch at random: mean of 10 000", {0.75, random.radiance.mean(), 5 * 0.00433});
    chapter.claim("7.4 one branch at random: standard error of that", {0.00433, se, 1e-4});
    chapter.claim("7.4 one branch at random: rays a tree", {9, double(random.rays) / 10'000, 0.5});
}

/// 7.5  Where does more depth stop paying?
void quality_against_cost(course::Chapter& chapter) {
    chapter.section("7.5 Quality against cost");
    auto chart = chapter.chart("quality", "The box with two balls: error against time", quality_axes());
    chart_quality(chart, box_with_balls(64), chapter.options());
    chart.caption("Against the same picture, 64 rays deep. Bars are one standard error.");
    const auto error = [&](const std::string& name, double effort) {
        for (const auto& row : chart.data().table.rows) {
            if (row[0].text() == name && std::abs(row[1].number() - effort) <= 1e-6 * effort)
                return row[3].number();
        }
        return HUGE_VAL;
    };
    for (const auto& [depth, percent, digit] :
         {std::tuple{1, 65.0, 1.0}, {2, 16, 1}, {3, 1.54, 0.01}, {4, 0.77, 0.01}, {8, 0.017, 0.001}})
        chapter.claim(fmt::format("7.5 all branches, depth {}: relative RMSE [%]", depth),
                      {percent, error(by_depth, depth), digit / 2});
    chapter.claim("7.5 cut off at 0.01: relative RMSE [%]", {0.43, error(cut_off, 0.01), 0.005});
    chapter.claim("7.5 cut off at 0.0001: relative RMSE [%]", {0.003, error(cut_off, 1e-4), 0.0005});
    chapter.claim_at_most("7.5 what depth 32 misses [%]", error(by_depth, 32), 1e-4);
    chapter.claim_at_most("7.5 all branches, depth 4, against 16 random ones: ratio of the errors",
                          error(by_depth, 4) / error(drawn, 16), 0.9);
}

/// 7.6  What do flat faces do to light?
void flat_faces(course::Chapter& chapter) {
    chapter.section("7.6 Flat faces");
    auto water = chapter.diagram("water", "Light from under water");
    draw_water(water, 4.0 / 3);
    water.caption("Dashed: where the light seems to come from. Beyond the window's edge nothing gets out.");
    const Prism prism;
    const auto  symmetric = bracketed_root([&](double angle) { return prism.asymmetry(angle); },
                                          Interval<double>{radians(30), radians(80)})
                               .value_or(0);
    auto diagram = chapter.diagram("prism", "A prism turns light");
    draw_prism(diagram, prism, symmetric);
    diagram.caption("The thick ray, whose way is symmetric, is turned least.");

    claim_flat_faces(chapter, prism, symmetric);
}

/// 7.7  And round ones?
void round_faces(course::Chapter& chapter) {
    chapter.section("7.7 Round faces");
    auto lens = chapter.diagram("ball_lens", "A ball of glass in sunlight");
    draw_ball_lens(lens, 1.5);
    lens.caption("Rays near the axis, orange, cross it in the focus, others before.");
    auto mirror = chapter.diagram("hollow_mirror", "A hollow mirror in sunlight");
    draw_hollow_mirror(mirror);
    mirror.caption("The focus is half way from the centre to the mirror, for rays near the axis, orange.");
    auto drop = chapter.diagram("rainbow", "A drop of water in sunlight");
    draw_rainbow(drop, 4.0 / 3, primary_bow(4.0 / 3).b);
    drop.caption("Most of the light comes back near the largest angle at which any does.");
    auto aberration = chapter.chart("aberration", "How far from the focus light crosses the axis",
                                    {.x   = "distance from the axis [radii]",
                                     .y   = "distance from the focus [radii]",
                                     .log = course::axis::xy});
    chart_aberration(aberration);
    auto angles =
        chapter.chart("rainbow_angles", "Where a drop sends sunlight that it reflects once",
                      {.x = "distance from the axis [radii]", .y = "angle to the sun's rays [degrees]"});
    chart_rainbow(angles);
    angles.caption("At the top, light from many places of the drop goes one way: there the bow is bright.");

    claim_round_faces(chapter);
}

/// 7.8  How many rays inside a ball do other things than they should?
void rays_inside_a_ball(course::Chapter& chapter) {
    const auto& options = chapter.options();
    auto        chart   = chapter.chart("inside_glass", "Light that stays in a ball of glass, in float",
                                        course::with_error({.x   = "radius of the ball [length units]",
                                                            .y   = "rays that go astray in 20 bounces [%]",
                                                            .log = course::axis::x}));
    chart_inside(chart, options.threads);
    chart.caption("Small balls are stepped over, large ones are met where the ray starts.");
    const auto claim = [&](const std::string& what, double expected, double measured, double tolerance) {
        chapter.claim("7.8 " + what, {expected, measured, tolerance});
    };
    double worst = 0;
    for (const double radius : ball_radii) worst = max_or_nan(worst, chart.at("error bound", radius));
    claim("error bound: rays that go astray, at the worst of the radii [%]", 0, worst, 0);
    for (const auto& [radius, astray] : {std::pair{1e-4, 50}, {1e2, 24}, {1e3, 100}})
        claim(fmt::format("fixed epsilon: rays that go astray at a radius of {} [%]", radius), astray,
              chart.at("fixed epsilon, $10^{-4}$", radius), 2);
    const auto drifted = count_inside(1, rays_inside, options.threads, leave_by_error_bound).drifted;
    claim("error bound: rays whose chord drifts by 1 % in 20 bounces [%]", 24,
          percent(share(drifted, rays_inside)).value, 0.5);
}

/// 7.8  What do many bounces do to numbers?
void after_many_bounces(course::Chapter& chapter) {
    chapter.section("7.8 After many bounces");
    auto at_border = chapter.chart(
        "border", "Total reflection or not, in float",
        course::with_error(
            {.x = "distance from the border [rad]", .y = "wrong answers [%]", .log = course::axis::x}));
    chart_border(at_border);
    at_border.caption("Every other angle is beyond the border. A float can't tell the nearest from it.");
    auto drifted =
        chapter.chart("drift", "Reflected again and again, in float",
                      {.x = "bounces", .y = "$\\left||\\mathbf{d}| - 1\\right|$", .log = course::axis::xy});
    chart_drift(drifted);
    drifted.caption(
        "The largest of twelve rays. Errors that are alike add up; those at random partly cancel.");

    const auto claim = [&](const std::string& what, double expected, double measured, double tolerance) {
        chapter.claim("7.8 " + what, {expected, measured, tolerance});
    };
    claim("border, 0.0001 rad: angles whose cosine is NaN in textbooks [%]", 50,
          at_border.at("textbook: the root is NaN", 1e-4), 0.5);
    double wrong = 0;
    for (const double distance : border_distances)
        if (distance >= 1e-7) wrong = max_or_nan(wrong, at_border.at("core: asked first", distance));
    claim("border, 1e-7 rad and more: angles at which the core errs [%]", 0, wrong, 0);
    claim("drift in a sphere, 100 000 bounces [%]", 1.5, 100 * drifted.at("school's, in a sphere", 1e5), 0.2);
    chapter.claim_at_most("7.8 drift if normalised, 100 000 bounces",
                          drifted.at("normalised, in a sphere", 1e5), 2e-7);
    rays_inside_a_ball(chapter);
    show_glass_balls(chapter);
}

}  // namespace
}  // namespace sr

int main(int argc, char** argv) {
    using namespace sr;
    const course::Defaults defaults{.samples        = course::ByQuality{4, 16, 64},
                                    .square_samples = true,
                                    .takes_seed     = false,
                                    .scene_section  = "7.1",
                                    .sampled_each   = "pixel of a render; those charted in 7.5 have 4"};
    return course::run(argc, argv, "07_recursion", "Recursion", defaults, [](course::Chapter& chapter) {
        const auto own = own_scene(chapter);  // first: what is wrong with it is told before any work is done
        what_is_seen(chapter, own);
        cost_of_recursion(chapter);
        how_deep(chapter);
        tree_of_rays(chapter);
        quality_against_cost(chapter);
        flat_faces(chapter);
        round_faces(chapter);
        after_many_bounces(chapter);
    });
}
