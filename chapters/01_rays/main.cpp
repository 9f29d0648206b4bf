/// @file main.cpp
/// Chapter 1, rays: what a camera sees along straight lines, found in two orders of the same two loops.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "course/chapter.hpp"
#include "course/number.hpp"
#include "diagrams.hpp"
#include "geometry/hierarchy.hpp"
#include "race.hpp"
#include "race_chart.hpp"
#include "scene/rasteriser.hpp"
#include "scene/visibility_difference.hpp"
#include "scenes.hpp"
#include "shading.hpp"
#include "statistics/slope.hpp"
#include "transport/primary.hpp"

namespace sr {
namespace {

double degrees(double radians) {
    return radians * 180 / std::numbers::pi;
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
        worst                       = std::fmax(worst, image ? length(*image - pixel) : HUGE_VAL);
    }
    chapter.claim_at_most("1.1 a ray's points project to its own pixel [pixel]", worst, 1e-9);
}

/// 1.2  What is seen along it?
void render(course::Chapter& chapter, const std::string& name, const std::string& title, const Shot& shot) {
    // Moved to the camera in double, then rounded: section 1.5 says why.
    const Hierarchy<float> hierarchy(convert<float>(to_camera_space(shot.scene.mesh, shot.camera)));
    const auto             camera  = convert<float>(in_camera_space(shot.camera));
    const int              threads = chapter.options().threads;
    const auto             depths  = depth_range(trace_primary(hierarchy, camera, {.threads = threads}));

    const int        rays  = chapter.options().samples;  // a square: course::run has seen to that
    const int        side  = int(std::sqrt(rays));
    const float      share = 1 / float(rays);
    Image<Look>      looks(camera.width, camera.height, {{}, {}, {}});
    course::Progress progress("tracing " + name, 1000);
    const auto on_tile = [&](int done, int of) { progress.tick(1000 * done / of - 1000 * (done - 1) / of); };
    for_each_pixel(camera.width, camera.height, {.threads = threads, .on_tile = on_tile}, [&](int x, int y) {
        for (int part = 0; part < rays; ++part) {
            const int  row = part / side, column = part % side;
            const Vec2 image{float(x) + (float(column) + 0.5F) / float(side),
                             float(y) + (float(row) + 0.5F) / float(side)};
            const auto hit = hierarchy.nearest(camera.ray(image));
            looks(x, y).add(
                share, hit ? look_at(shot.scene, hit->face, shot.camera.ray(image).direction, hit->t, depths)
                           : Look{});
        }
    });

    if (std::none_of(looks.pixels().begin(), looks.pixels().end(), is_something))
        chapter.note(name + ": no ray hits anything, its pictures are blank");

    const auto facts =
        fmt::format("{}, {} a pixel", course::counted(std::ssize(shot.scene.mesh.faces), "triangle"),
                    course::counted(rays, "ray"));
    const auto show = [&](const std::string& suffix, Spectrum Look::*way, const std::string& by,
                          const std::string& meaning) {
        Image<Spectrum> film(camera.width, camera.height);
        for (std::size_t i = 0; i < film.pixels().size(); ++i) film.pixels()[i] = looks.pixels()[i].*way;
        chapter.render(name + "_" + suffix, title + " by " + by, facts + ": " + meaning + ".", film);
    };
    show("depth", &Look::depth, "depth", "bright is near, by the square of the nearness; black is nothing");
    show("normal", &Look::normal, "normal", "each axis is a primary colour");
    show("head_light", &Look::head_light, "a head light", "a light at the eye, equation (1.4)");
}

void what_is_seen(course::Chapter& chapter) {
    chapter.section("1.2 What is seen along it");
    const auto& options = chapter.options();
    if (options.scene) {
        render(chapter, "scene", "The scene", shot_of_file(*options.scene, options.size));
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
template <class T>
VisibilityDifference compare(const Mesh<double>& exact, const Camera<double>& exact_camera, int threads) {
    const auto         mesh   = convert<T>(exact);
    const auto         camera = convert<T>(exact_camera);
    const Hierarchy<T> hierarchy(mesh);
    return compare_visibility(trace_primary(hierarchy, camera, {.threads = threads}), rasterise(mesh, camera),
                              mesh, camera);
}

void loops_swapped(course::Chapter& chapter) {
    chapter.section("1.4 The loops swapped");
    auto diagram = chapter.diagram("two_loops", "The same two loops in two orders");
    draw_two_loops(diagram);
    diagram.caption(
        "A ray tracer asks all triangles for one pixel, a rasteriser all pixels for one triangle.");

    constexpr int side    = 256;  // whatever the pictures' size: these numbers are in the text
    const int     threads = chapter.options().threads;
    course::Rows  table{{"scene", "space", "precision", "pixels hit", "hit or missed", "other triangle",
                         "at an edge", "at a tie", "unexplained"}};
    for (const auto& [name, shot, pixels_hit, float_differs] :
         {std::tuple{"Cornell box", cornell_shot(side), 61'195, 0},
          {"teapot", teapot_shot(64, side), 13'790, 1}}) {
        const auto moved_mesh   = to_camera_space(shot.scene.mesh, shot.camera);
        const auto moved_camera = in_camera_space(shot.camera);
        for (const auto& [space, precision, other, difference] :
             {std::tuple{"world", "float", float_differs,
                         compare<float>(shot.scene.mesh, shot.camera, threads)},
              {"world", "double", 0, compare<double>(shot.scene.mesh, shot.camera, threads)},
              {"camera", "float", 0, compare<float>(moved_mesh, moved_camera, threads)},
              {"camera", "double", 0, compare<double>(moved_mesh, moved_camera, threads)}}) {
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
double wrong_pixels(const VisibilityImage<float>& image, const VisibilityImage<double>& exact) {
    int wrong = 0;
    for (std::size_t i = 0; i < exact.pixels().size(); ++i)
        wrong += image.pixels()[i].face != exact.pixels()[i].face ? 1 : 0;
    return wrong / double(exact.pixels().size());
}

double covered_pixels(const VisibilityImage<double>& image) {
    const auto hit =
        std::count_if(image.pixels().begin(), image.pixels().end(), [](const auto& p) { return p.hit(); });
    return double(hit) / double(image.pixels().size());
}

void far_from_the_origin(course::Chapter& chapter) {
    chapter.section("1.5 Far from the origin");
    auto       chart = chapter.chart("far_from_the_origin", "A teapot and its camera, moved together",
                                     {.x   = "distance from the origin [teapot lengths]",
                                      .y   = "pixels that see another triangle [%]",
                                      .log = course::axis::xy});
    const auto shot  = teapot_shot(16, 256);
    const auto exact = rasterise(shot.scene.mesh, shot.camera);
    for (double distance = 1; distance <= 1e7; distance *= 10) {
        const Vector3<double> offset = 6.5 * distance * normalize(Vector3<double>{3, 4, 5});
        auto                  mesh   = shot.scene.mesh;
        auto                  camera = shot.camera;
        for (auto& vertex : mesh.vertices) vertex += offset;
        camera.position += offset;

        const auto world = convert<float>(mesh);
        const auto moved = convert<float>(to_camera_space(mesh, camera));
        chart.add("float, world space", distance,
                  100 * wrong_pixels(trace_primary(Hierarchy<float>(world), convert<float>(camera)), exact));
        chart.add("float, camera space", distance,
                  100 * wrong_pixels(
                            trace_primary(Hierarchy<float>(moved), convert<float>(in_camera_space(camera))),
                            exact));
    }
    chapter.claim("1.5 in camera space, pixels wrong at 1e+07 lengths [%]",
                  {.expected = 0, .measured = chart.at("float, camera space", 1e7), .tolerance = 0.01});
    std::vector<double> distances, shares;
    for (double distance = 10; distance <= 1e5; distance *= 10) {
        distances.push_back(distance);
        shares.push_back(chart.at("float, world space", distance));
    }
    chapter.claim("1.5 in world space, wrong pixels grow with the power of the distance",
                  {.expected = 1, .measured = log_log_slope(distances, shares).value, .tolerance = 0.05});
    for (const auto& [distance, share] : {std::pair{1e4, 1.9}, {1e5, 18.8}, {1e7, 61.4}}) {
        chapter.claim(
            fmt::format("1.5 in world space, pixels wrong at {:.0e} lengths [%]", distance),
            {.expected = share, .measured = chart.at("float, world space", distance), .tolerance = 0.05});
    }
    chapter.claim("1.5 pixels that the teapot covers [%]",
                  {.expected = 33.6, .measured = 100 * covered_pixels(exact), .tolerance = 0.05});
    chart.caption(
        "Subtract the camera's position in double before rounding to float, and the distance no longer "
        "matters.");
}

/// 1.6  How many pixels see another triangle than the rasteriser in double says? Of images 256 wide, whatever
/// the race's: these numbers are in the text.
void errors_of_the_race(course::Chapter& chapter) {
    course::Rows table{{"triangles", "rasteriser [%]", "rays, hierarchy [%]"}};
    double       worst = 0;
    for (const int level : {1, 2, 4, 8, 16, 32}) {
        const auto mesh   = teapot(level);
        const auto camera = teapot_camera(256, 256);
        const auto exact  = rasterise(mesh, camera);
        const auto near   = convert<float>(mesh);
        const auto seen   = convert<float>(camera);
        const auto raster = 100 * wrong_pixels(rasterise(near, seen), exact);
        const auto rays   = 100 * wrong_pixels(trace_primary(Hierarchy<float>(near), seen), exact);
        table.add({mesh.faces.size(), raster, rays});
        if (level > 1) worst = std::fmax(worst, std::fmax(raster, rays));
    }
    chapter.say(table);
    const auto triangles = [&](std::size_t row) { return table.rows[row][0].number(); };
    chapter.claim("1.6 triangles of the coarsest teapot", {.expected = 52, .measured = triangles(0)});
    chapter.claim("1.6 its wrong pixels, rasteriser [%]",
                  {.expected = 0.7, .measured = table.rows[0][1].number(), .tolerance = 0.05});
    chapter.claim("1.6 its wrong pixels, rays [%]",
                  {.expected = 0.8, .measured = table.rows[0][2].number(), .tolerance = 0.05});
    chapter.claim("1.6 triangles of the next finer one", {.expected = 240, .measured = triangles(1)});
    chapter.claim_at_most("1.6 most wrong pixels in 10 000, of this and all that are finer", 100 * worst, 1);
}

/// 1.6  Which is faster?
void which_is_faster(course::Chapter& chapter) {
    chapter.section("1.6 Which is faster");
    const bool   draft   = chapter.options().quality == course::Quality::draft;
    const int    repeats = draft ? 1 : 3;
    const double tests   = draft ? 2e6 : 1.5e7;
    const int    side    = std::min(chapter.options().size, 2048);  // beyond, a race takes gigabytes

    auto by_triangles =
        chapter.chart("triangles", fmt::format("One image of ${0} \\times {0}$ pixels, one thread", side),
                      race_axes("triangles"));
    Curves                 triangles;
    const std::vector<int> levels{1, 2, 4, 8, 16, 32, 64, 125};
    std::vector<int>       edges{16};
    while (edges.back() < 2 * side) edges.push_back(2 * edges.back());
    course::Progress progress("racing", int(levels.size() + edges.size()));
    for (const int level : levels) {
        const Race race(level, side);
        add(by_triangles, triangles, race, race.run(repeats, tests, chapter.options().seed),
            double(race.triangles()));
        progress.tick();
    }
    const std::string scaled = " \"Rays, all triangles\" is timed on random pixels and scaled.";
    by_triangles.caption(
        mark_crossing(by_triangles, triangles, "rasteriser", "rays, hierarchy", "triangles") + scaled);

    constexpr int level           = 32;
    const auto    triangles_shown = course::counted(std::ssize(teapot(level).faces), "triangle");
    auto   by_pixels = chapter.chart("pixels", fmt::format("One image of {}, one thread", triangles_shown),
                                     race_axes("pixels"));
    Curves pixels;
    for (const int edge : edges) {
        const Race race(level, edge);
        add(by_pixels, pixels, race, race.run(repeats, tests, chapter.options().seed), double(race.pixels()));
        progress.tick();
    }
    by_pixels.caption(mark_crossing(by_pixels, pixels, "rays, hierarchy", "rasteriser", "pixels") + scaled);
}

}  // namespace
}  // namespace sr

int main(int argc, char** argv) {
    using namespace sr;
    const course::Defaults defaults{
        .size = {128, 512, 1024}, .samples = {1, 16, 16}, .renders_scene = true, .square_samples = true};
    return course::run(argc, argv, "01_rays", "Rays", defaults, [](course::Chapter& chapter) {
        pinhole(chapter);
        what_is_seen(chapter);
        ray_optics(chapter);
        loops_swapped(chapter);
        rounding(chapter);
        far_from_the_origin(chapter);
        which_is_faster(chapter);
        errors_of_the_race(chapter);
    });
}
