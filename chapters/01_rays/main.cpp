/// @file main.cpp
/// Chapter 1, rays: what a camera sees along straight lines, found in two orders of the same two loops.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "course/chapter.hpp"
#include "diagrams.hpp"
#include "far_from_the_origin.hpp"
#include "geometry/hierarchy.hpp"
#include "math/degrees.hpp"
#include "math/extremes.hpp"
#include "race_chart.hpp"
#include "render.hpp"
#include "scene/rasteriser.hpp"
#include "scenes.hpp"
#include "statistics/slope.hpp"
#include "transport/primary.hpp"
#include "transport/swapped_loops.hpp"
#include "wrong_pixels.hpp"

namespace sr {
namespace {

/// The scene of --scene.
std::optional<Shot> own_scene(course::Chapter& chapter) {
    const auto& options = chapter.options();
    if (!options.scene) return std::nullopt;
    return view_of_file(*options.scene, options.size, [&](std::string_view line) { chapter.note(line); });
}

/// 1.1  Which ray belongs to a pixel?
void pinhole(course::Chapter& chapter) {
    chapter.section("1.1 A ray for each pixel");
    auto diagram = chapter.diagram("camera", "The pinhole camera and its rays");
    draw_camera(diagram);
    diagram.caption(
        "The ray through a pixel starts in the pinhole $\\mathbf{o}$ and has its direction's end, $t = 1$, "
        "in the image plane.");

    const auto camera = cornell_box_camera(chapter.options().size);
    const auto corner = camera.ray({0, 0}).direction;
    for (const auto& [which, aside] :
         {std::pair{"from left to right", corner.x}, {"from top to bottom", corner.y}}) {
        chapter.claim(
            fmt::format("1.1 the Cornell camera sees, {} [deg]", which),
            {.expected = 39.30765, .measured = 2 * degrees(std::atan2(aside, corner.z)), .tolerance = 5e-5});
    }

    double worst = 0;
    for (int i = 0; i < camera.width; ++i) {
        const Vector2<double> pixel{i + 0.5, camera.height - i - 0.5};
        const auto            image = camera.project(camera.ray(pixel).at(2.5));
        worst                       = max_or_nan(worst, image ? length(*image - pixel) : HUGE_VAL);
    }
    chapter.claim_at_most("1.1 a ray's points project to its own pixel [pixel]", worst, 1e-9);
}

/// 1.2  What is seen along it?
/// @param own  scene, of the person who asks, in place of ours
void what_is_seen(course::Chapter& chapter, const std::optional<Shot>& own) {
    chapter.section("1.2 What is seen along it");
    const auto& options = chapter.options();
    if (own) {
        render(chapter, "scene", "The scene", *own);
    } else {
        render(chapter, "cornell_box", "The Cornell box", cornell_shot(options.size));
        render(chapter, "teapot", "The teapot", teapot_shot(64, options.size));
    }
}

/// 1.3  What do rays leave out?
void ray_optics(course::Chapter& chapter) {
    chapter.section("1.3 What rays leave out");
    constexpr double speed_of_light = 299'792'458;  // [m/s]
    constexpr double wavelength     = 550e-9;       // [m], green
    using namespace cornell_camera;

    double depth = 0;  // [m], of the Cornell box
    for (const auto& vertex : cornell_box().mesh.vertices) depth = std::fmax(depth, vertex.z * 1e-3);
    chapter.claim("1.3 light crosses the Cornell box in [ns]",
                  {.expected = 1.865, .measured = depth / speed_of_light * 1e9, .tolerance = 5e-4});

    // A hole of diameter D blurs a far point to a disk of D by its size and of 2.44 lambda f / D by diffraction.
    const double best = std::sqrt(2.44 * wavelength * focal_length);
    chapter.claim("1.3 a real pinhole of this camera is best at [mm]",
                  {.expected = 0.217, .measured = best * 1e3, .tolerance = 5e-4});
    chapter.claim("1.3 and resolves so many points across its film",
                  {.expected = 115, .measured = film_side / best, .tolerance = 0.5});
}

/// 1.4  Is the image the same if the loops are swapped?
void loops_swapped(course::Chapter& chapter) {
    chapter.section("1.4 The loops swapped");
    auto diagram = chapter.diagram("two_loops", "The same two loops in two orders");
    draw_two_loops(diagram);
    diagram.caption(
        "A ray tracer asks all triangles for one pixel, a rasteriser all pixels for one triangle.");

    constexpr int  side = 256;  // whatever the pictures' size: these numbers are in the text
    const TileLoop loop{.threads = chapter.options().threads};
    course::Rows   table{{"scene", "space", "precision", "pixels hit", "hit or missed", "other triangle",
                          "at an edge", "at a tie", "unexplained"}};
    for (const auto& [name, shot, pixels_hit, float_differs] :
         {std::tuple{"Cornell box", cornell_shot(side), 61'195, 0},
          {"teapot", teapot_shot(64, side), 13'790, 1}}) {
        const auto moved_mesh   = to_camera_space(shot.scene.mesh, shot.camera);
        const auto moved_camera = in_camera_space(shot.camera);
        for (const auto& [space, precision, other, difference] :
             {std::tuple{"world", "float", float_differs,
                         compare_swapped_loops<float>(shot.scene.mesh, shot.camera, loop)},
              {"world", "double", 0, compare_swapped_loops<double>(shot.scene.mesh, shot.camera, loop)},
              {"camera", "float", 0, compare_swapped_loops<float>(moved_mesh, moved_camera, loop)},
              {"camera", "double", 0, compare_swapped_loops<double>(moved_mesh, moved_camera, loop)}}) {
            table.add({name, space, precision, difference.hit, difference.hit_or_missed,
                       difference.other_triangle, difference.at_edge, difference.at_tie,
                       difference.unexplained});
            const auto which = fmt::format("1.4 {}, {} in {} space: pixels", name, precision, space);
            const auto claim = [&](const std::string& what, int expected, int measured) {
                chapter.claim(which + what, {.expected = double(expected), .measured = double(measured)});
            };
            claim(" hit by one only", 0, difference.hit_or_missed);
            claim(" hit by both", pixels_hit, difference.hit);
            claim(" that name another triangle", other, difference.other_triangle);
            claim(" that do, at an edge", other, difference.at_edge);
            claim(" that do, at a tie in depth", 0, difference.at_tie);
            claim(" that do, without an excuse", 0, difference.unexplained);
        }
    }
    chapter.say(table);
}

/// 1.4  How finely does a direction of some 300 pixels' length tell pixels apart?
template <class T>
double step_at(T length) {
    return double(std::nextafter(length, 2 * length) - length);
}

void rounding(course::Chapter& chapter) {
    chapter.claim("1.4 steps of a float of 300 pixels [pixel]",
                  {.expected = 3e-5, .measured = step_at(300.0F), .tolerance = 0.5e-5});
    chapter.claim("1.4 steps of a double of 300 pixels [pixel]",
                  {.expected = 6e-14, .measured = step_at(300.0), .tolerance = 0.5e-14});
}

/// 1.5  What if the whole scene stands far from the origin?
double percent_covered(const VisibilityImage<double>& image) {
    const auto hit =
        std::count_if(image.pixels().begin(), image.pixels().end(), [](const auto& p) { return p.hit(); });
    return 100.0 * double(hit) / double(image.pixels().size());
}

void far_from_the_origin(course::Chapter& chapter) {
    chapter.section("1.5 Far from the origin");
    const auto                shot  = teapot_shot(16, 256);
    const auto                exact = rasterise(shot.scene.mesh, shot.camera);
    const std::vector<double> distances{1, 10, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7};
    const auto                chart = chart_far_from_the_origin(chapter, shot, exact, distances);

    double worst = 0;
    for (const double distance : distances)
        worst = max_or_nan(worst, chart.at("float, camera space", distance));
    chapter.claim("1.5 in camera space, pixels wrong at the worst of the distances [%]", {.measured = worst});

    // From where some pixels are wrong to where wrong ones hide each other.
    const std::vector<double> growing(distances.begin() + 1, distances.begin() + 6);
    std::vector<double>       shares;
    for (const double distance : growing) shares.push_back(chart.at("float, world space", distance));
    const Slope slope = log_log_slope(growing, shares);
    chapter.say(fmt::format("From {} to {} lengths wrong pixels grow with the power {:.3f} +- {:.3f}.",
                            growing.front(), growing.back(), slope.value, slope.standard_error));
    chapter.claim("1.5 in world space, wrong pixels grow with the power of the distance",
                  {.expected = 1, .measured = slope.value, .tolerance = 0.05});
    for (const auto& [distance, share] : {std::pair{1e4, 1.9}, {1e5, 18.8}, {1e7, 61.4}}) {
        chapter.claim(
            fmt::format("1.5 in world space, pixels wrong at {:.0e} lengths [%]", distance),
            {.expected = share, .measured = chart.at("float, world space", distance), .tolerance = 0.05});
    }
    chapter.claim("1.5 pixels that the teapot covers [%]",
                  {.expected = 33.6, .measured = percent_covered(exact), .tolerance = 0.05});
}

/// 1.6  How many pixels see another triangle than the rasteriser in double says? Of images 256 wide, whatever
/// the race's: these numbers are in the text.
void errors_of_the_race(course::Chapter& chapter) {
    course::Rows   table{{"triangles", "rasteriser [%]", "rays, hierarchy [%]"}};
    double         worst = 0;
    const TileLoop loop{.threads = chapter.options().threads};
    for (const int level : {1, 2, 4, 8, 16, 32}) {
        const auto mesh   = teapot(level);
        const auto camera = teapot_camera(256, 256);
        const auto exact  = rasterise(mesh, camera);
        const auto near   = convert<float>(mesh);
        const auto seen   = convert<float>(camera);
        const auto raster = percent_wrong(rasterise(near, seen), exact);
        const auto rays   = percent_wrong(trace_primary(Hierarchy<float>(near), seen, loop), exact);
        table.add({mesh.faces.size(), raster, rays});
        if (level > 1) worst = max_or_nan(worst, max_or_nan(raster, rays));
    }
    chapter.say(table);
    const auto triangles = [&](std::size_t row) { return table.rows[row][0].number(); };
    chapter.claim("1.6 triangles of the coarsest teapot", {.expected = 52, .measured = triangles(0)});
    chapter.claim("1.6 its wrong pixels, rasteriser [%]",
                  {.expected = 0.7, .measured = table.rows[0][1].number(), .tolerance = 0.05});
    chapter.claim("1.6 its wrong pixels, rays [%]",
                  {.expected = 0.8, .measured = table.rows[0][2].number(), .tolerance = 0.05});
    chapter.claim("1.6 triangles of the next finer one", {.expected = 240, .measured = triangles(1)});
    chapter.claim("1.6 triangles of the finest one here",
                  {.expected = 65'280, .measured = triangles(table.rows.size() - 1)});
    chapter.claim_at_most("1.6 most wrong pixels in 10 000, of these two and all between", 100 * worst, 1);
}

/// 1.6  Which is faster?
void which_is_faster(course::Chapter& chapter) {
    chapter.section("1.6 Which is faster");
    const int side = std::min(chapter.options().size, 2048);  // beyond, a race takes gigabytes
    race_by_triangles(chapter, side);
    race_by_pixels(chapter, side);
}

}  // namespace
}  // namespace sr

int main(int argc, char** argv) {
    using namespace sr;
    const course::Defaults defaults{.samples        = course::ByQuality{1, 16, 16},
                                    .square_samples = true,
                                    .scene_section  = "1.2",
                                    .seeded         = "the pixels that races ask, 1.6"};
    return course::run(argc, argv, "01_rays", "Rays", defaults, [](course::Chapter& chapter) {
        const auto own = own_scene(chapter);  // first: what is wrong with it is told before any work is done
        pinhole(chapter);
        what_is_seen(chapter, own);
        ray_optics(chapter);
        loops_swapped(chapter);
        rounding(chapter);
        far_from_the_origin(chapter);
        which_is_faster(chapter);
        errors_of_the_race(chapter);
    });
}
