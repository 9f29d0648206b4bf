/// @file main.cpp
/// Chapter 4, boxes: how not to ask most of the triangles.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "balls.hpp"
#include "border_chart.hpp"
#include "box_diagram.hpp"
#include "chances.hpp"
#include "counted_work.hpp"
#include "course/chapter.hpp"
#include "geometry/hierarchy.hpp"
#include "ladder_chart.hpp"
#include "lost_hits_chart.hpp"
#include "math/extremes.hpp"
#include "nodes_per_pixel.hpp"
#include "scene/teapot.hpp"
#include "slab_diagram.hpp"
#include "textbook_slabs.hpp"
#include "work.hpp"

namespace sr {
namespace {

const Box<float> cube{Vec3(-1), Vec3(1)};

/// 4.1  When is a ray in a box?
void slabs(course::Chapter& chapter) {
    chapter.section("4.1 Slabs");
    auto diagram = chapter.diagram("slabs", "A box is where its slabs overlap");
    draw_slabs(diagram);
    diagram.caption(
        "A ray is in the box while it is in both slabs. On the left the last entry comes before the first "
        "exit; on "
        "the right the ray has left the $y$ slab before it enters the other.");

    const auto inside = padded_clip<double>({{-3, -2, -2.5}, {1, 0.5, 0.75}}, {{-1, -1, -1}, {1, 1, 1}}, 1);
    chapter.claim("4.1 the example enters at", {.expected = 2, .measured = inside.min});
    chapter.claim("4.1 the example leaves at", {.expected = 4, .measured = inside.max});

    // The Cornell box's lamp is flat: its slab in y has no thickness, and entry and exit are the same.
    const Box<float> lamp{{213, 548.8F, 227}, {343, 548.8F, 332}};
    constexpr int    rays   = 100'000;
    int              strict = 0, closed = 0;
    for (int i = 0; i < rays; ++i) {
        Rng         rng{1, i, 0, 0};
        const float u = rng.uniform(), v = rng.uniform();
        const Vec3  eye{278, 273, -800};
        const auto  in = padded_clip<float>({eye, Vec3{213 + 130 * u, 548.8F, 227 + 105 * v} - eye}, lamp, 1);
        strict += in.min < in.max ? 1 : 0;
        closed += in.min <= in.max ? 1 : 0;
    }
    chapter.claim("4.1 rays at the flat lamp that < accepts [%]", {.measured = 100.0 * strict / rays});
    chapter.claim("4.1 rays at the flat lamp that <= accepts [%]",
                  {.expected = 100, .measured = 100.0 * closed / rays});
}

/// 4.2  What if the ray runs along a slab?
void zeros(course::Chapter& chapter) {
    chapter.section("4.2 Zeros of both signs");
    const std::array<Ray<float>, 4> in_a_face{Ray<float>{{-1, 0, -5}, {0, 0, 1}},
                                              {{1, 0, -5}, {0, 0, 1}},
                                              {{-5, 0, -1}, {1, 0, 0}},
                                              {{-5, 0, 1}, {1, 0, 0}}};
    const auto                      found = [&](const auto& clip_ray) {
        int count = 0;
        for (const auto& ray : in_a_face) count += clip_ray(ray).empty() ? 0 : 1;
        return double(count);
    };
    const auto textbook = [&](MinMax how) {
        return found([how](const Ray<float>& ray) { return textbook_clip(ray, cube, how); });
    };
    chapter.claim("4.2 rays in a face, of 4, that are found, running value first",
                  {.expected = 2, .measured = textbook(MinMax::running_first)});
    chapter.claim("4.2 the same, running value second",
                  {.expected = 1, .measured = textbook(MinMax::running_second)});
    chapter.claim("4.2 the same, by fmin and fmax", {.expected = 0, .measured = textbook(MinMax::ieee)});
    const auto core = [](const Ray<float>& ray) { return BoxRay<float>(ray).clip(cube, in_front<float>); };
    chapter.claim("4.2 the same, by the core", {.expected = 4, .measured = found(core)});

    const Ray<float> minus_zero{{0, 0, -5}, {-0.0F, 0, 1}};
    chapter.claim(
        "4.2 a ray through the middle with -0, by the sign of d, is found",
        {.expected = 0, .measured = clip_by_sign_of_direction(minus_zero, cube).empty() ? 0.0 : 1.0});
    chapter.claim("4.2 the same ray, by the sign of 1/d, is found",
                  {.expected = 1, .measured = core(minus_zero).empty() ? 0.0 : 1.0});
}

/// 4.3  How many true hits does rounding lose?
void lost_at_corners(course::Chapter& chapter) {
    chapter.section("4.3 Corners");
    const auto lost   = chart_lost_hits(chapter);
    double     padded = 0, core = 0;
    for (const auto& [place, percent] : lost) {
        padded = max_or_nan(padded, percent.padded.back());
        core   = max_or_nan(core, percent.core);
    }
    for (const auto& [place, expected] :
         {std::pair{"corner", 8.5}, {"edge", 3.8}, {"vertex of a teapot", 2.9}})
        chapter.claim(fmt::format("4.3 true hits lost without padding, {} [%]", place),
                      {.expected = expected, .measured = lost.at(place).padded.front(), .tolerance = 0.05});
    chapter.claim(
        "4.3 true hits lost with exits longer by 2^-23, corner [%]",
        {.expected = 0.24, .measured = lost.at("corner").padded[paddings_per_unit], .tolerance = 0.005});
    chapter.claim("4.3 true hits lost in the interior [%]", {.measured = lost.at("interior").padded.front()});
    chapter.claim("4.3 true hits lost with 1 + 2 gamma_3, at any of these places [%]", {.measured = padded});
    chapter.claim("4.3 true hits lost by the core [%]", {.measured = core});
}

/// 4.4  Who is met by a random line?
void surfaces_are_chances(course::Chapter& chapter) {
    chapter.section("4.4 Surfaces are chances");
    const Draw   draw{.lines = 400'000, .seed = chapter.options().seed, .threads = chapter.options().threads};
    const auto   chances = chart_chances(chapter, draw);
    const double worst   = max_or_nan(measure_bodies(chapter, draw), chances.worst);
    chapter.claim_at_most("4.4 the worst of all estimates lies off by [standard errors]", worst, 5);
    for (const auto& [name, expected] : {std::pair{"ball", 52.4}, {"tetrahedron", 57.7}}) {
        const Running& met = chances.share.at(name);
        chapter.claim(fmt::format("4.4 counted: lines at a cube that meet the {} in it [%]", name),
                      {.expected  = expected,
                       .measured  = 100 * met.mean(),
                       .tolerance = 5 * 100 * met.standard_error()});
    }

    const auto sums = surfaces(boxes_of(convert<float>(teapot(16)), Cut::binned).tree());
    chapter.claim("4.4 surface of a hierarchy's balls, for each of its boxes",
                  {.expected = 1.9, .measured = sums.balls / sums.boxes, .tolerance = 0.05});
}

/// 4.5  Where is a set of triangles best cut?
void where_to_cut(course::Chapter& chapter) {
    chapter.section("4.5 Where to cut");
    auto diagram = chapter.diagram("boxes", "The same teapot, cut six times");
    draw_boxes(diagram, convert<float>(teapot(16)));
    diagram.caption(
        "Its outline, and its boxes six cuts below the root, from the side: the median's halves reach over "
        "gaps, "
        "the sweep's least expected cost does not.");

    course::Rows             table{{"cut", "asked", "nodes", "error", "triangles", "error"}};
    double                   off = 0, nodes_error = 0, triangles_error = 0;
    std::vector<CountedWork> trees;
    for (const auto& [rung, in_text] :
         {std::pair{rungs[0], std::array{25.09, 12.00, 25.1, 12.01, 13.4, 4.75, 13.7, 4.64}},
          {rungs[1], {21.66, 4.55, 21.7, 4.55, 11.2, 1.74, 11.0, 1.67}},
          {rungs[2], {21.21, 4.56, 21.2, 4.56, 11.0, 1.73, 10.7, 1.65}}}) {
        const auto& work =
            trees.emplace_back(count_work(convert<float>(teapot(16)), rung.cut, chapter.options().threads));
        off              = max_or_nan(off, work.off());
        nodes_error      = max_or_nan(nodes_error, work.worst_error(&Work::nodes));
        triangles_error  = max_or_nan(triangles_error, work.worst_error(&Work::triangles));
        const auto claim = [&](const std::string& rays, double nodes, double triangles, std::size_t text) {
            chapter.claim(
                fmt::format("4.5 {}: nodes, {}", rung.name, rays),
                {.expected = in_text[text], .measured = nodes, .tolerance = text == 0 ? 0.005 : 0.05});
            chapter.claim(fmt::format("4.5 {}: triangles, {}", rung.name, rays),
                          {.expected = in_text[text + 1], .measured = triangles, .tolerance = 0.005});
        };
        const auto add = [&](const std::string& rays, const Work& of, std::size_t text) {
            table.add({rung.name, rays, of.nodes.mean(), of.nodes.standard_error(), of.triangles.mean(),
                       of.triangles.standard_error()});
            claim(rays, of.nodes.mean(), of.triangles.mean(), text);
        };
        table.add({rung.name, "expected", work.expected.nodes, 0, work.expected.triangles, 0});
        claim("expected", work.expected.nodes, work.expected.triangles, 0);
        add("lines, all along", work.lines.whole, 2);
        add("lines, to the nearest hit", work.lines.nearest, 4);
        add("camera rays", work.pixels, 6);
    }
    chapter.say(table);
    chapter.claim_at_most("4.5 standard errors of the nodes", nodes_error, 0.1);
    chapter.claim_at_most("4.5 standard errors of the triangles", triangles_error, 0.08);
    const auto& [median, binned, swept] = std::tie(trees[0].expected, trees[1].expected, trees[2].expected);
    chapter.claim("4.5 triangles asked along lines, median for each of binned",
                  {.expected = 2.6, .measured = median.triangles / binned.triangles, .tolerance = 0.05});
    chapter.claim("4.5 cost of the swept tree below the binned one's [%]",
                  {.expected = 2, .measured = 100 * (1 - swept.cost() / binned.cost()), .tolerance = 0.5});
    chapter.claim_at_most("4.5 the expectation is off, at most, by [standard errors]", off, 5);
}

/// 4.6  Where in the picture is the work?
void work_in_the_picture(course::Chapter& chapter) {
    chapter.section("4.6 The picture of the work");
    constexpr NodeScale scale{.most = 100, .notch = 20};
    const int           width = chapter.options().size;
    const auto          mesh  = convert<float>(teapot(64));
    for (const auto& [name, cut] : rungs) {
        const auto    counts = count_per_pixel(boxes_of(mesh, cut), teapot_view(width, width * 5 / 8),
                                               {.threads = chapter.options().threads});
        std::uint64_t most   = 0;
        for (const auto& count : counts.pixels()) most = std::max(most, count.nodes);
        chapter.say(fmt::format("{}: {} nodes at most", name, most));
        chapter.render(
            "nodes_" + name, "Nodes that each pixel's ray asks, " + name + " cut",
            fmt::format("The scale below goes from 0 to {} nodes, with a notch for each {}; what asks "
                        "more, {} at most, has the last colour. Colours follow the square root.",
                        scale.most, scale.notch, most),
            in_colour(counts, scale));
    }
}

/// 4.7  What does it cost, and from when on does it pay?
void what_it_costs(course::Chapter& chapter) {
    chapter.section("4.7 When it pays");
    climb_the_ladder(chapter);
    chart_border(chapter);
}

}  // namespace
}  // namespace sr

int main(int argc, char** argv) {
    using namespace sr;
    const course::Defaults defaults{.seeded = "lines, 4.4, and rays, 4.7: with others claims may fail"};
    return course::run(argc, argv, "04_boxes", "Boxes", defaults, [](course::Chapter& chapter) {
        slabs(chapter);
        zeros(chapter);
        lost_at_corners(chapter);
        surfaces_are_chances(chapter);
        where_to_cut(chapter);
        work_in_the_picture(chapter);
        what_it_costs(chapter);
    });
}
