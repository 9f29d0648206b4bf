/// @file main.cpp
/// Chapter 3, triangles: one small system of equations, solved in three ways, and what becomes of each at an edge.
/// `./course figures 03 --size 288 --publish` makes published pictures that are small files.

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>

#include "attack.hpp"
#include "course/chapter.hpp"
#include "course/number.hpp"
#include "diagrams.hpp"
#include "leak_chart.hpp"
#include "leak_picture.hpp"
#include "math/difference_of_products.hpp"
#include "math/extremes.hpp"
#include "shapes.hpp"
#include "slits.hpp"

namespace sr {
namespace {

/// 3.1  How is a point of a triangle named?
void weights(course::Chapter& chapter) {
    chapter.section("3.1 The weights of a point");
    auto diagram = chapter.diagram("weights", "A point of a triangle, by the weights of its vertices");
    draw_weights(diagram);
    diagram.caption("The weight $b_1$ is the share of the orange area, $b_2$ that of the blue one.");

    const Triangle<double> triangle{{0, 0, 1}, {3, 0, 2}, {1, 4, -1}};
    const auto             p     = 0.25 * triangle.a + 0.25 * triangle.b + 0.5 * triangle.c;
    const double           whole = area(triangle);
    chapter.claim("3.1 share of the area opposite the second vertex",
                  {.expected  = 0.25,
                   .measured  = area<double>({p, triangle.c, triangle.a}) / whole,
                   .tolerance = 1e-15});
    chapter.claim(
        "3.1 share of the area opposite the third vertex",
        {.expected = 0.5, .measured = area<double>({p, triangle.a, triangle.b}) / whole, .tolerance = 1e-15});
}

/// The ray and the triangle of sections 3.2 and 3.3.
const Triangle<double> example{{-1, -1, 2}, {2, -1, 3}, {0, 3, 1}};
const Ray<double>      example_ray{{0, 0, -1}, {0.1, 0.2, 1}};

/// How far t, b1 or b2 is from the solution in fractions.
double furthest(const Hit<double>& hit) {
    return max_or_nan(std::abs(hit.t - 90 / 31.0),
                      max_or_nan(std::abs(hit.uv.x - 37 / 124.0), std::abs(hit.uv.y - 49 / 124.0)));
}

/// 3.2  Where does a ray meet it?
void cramer(course::Chapter& chapter) {
    chapter.section("3.2 Three equations by Cramer's rule");
    const auto hit = intersect_moeller_trumbore(example, example_ray, in_front<double>).value();
    chapter.claim("3.2 t of the example", {.expected = 2.9032258, .measured = hit.t, .tolerance = 5e-8});
    chapter.claim("3.2 b1 of the example", {.expected = 0.2983871, .measured = hit.uv.x, .tolerance = 5e-8});
    chapter.claim("3.2 b2 of the example", {.expected = 0.3951613, .measured = hit.uv.y, .tolerance = 5e-8});
    const auto [a, b, c] = example;
    chapter.claim(
        "3.2 the determinant, negated",
        {.expected = 12.4, .measured = -dot(cross(example_ray.direction, c - a), b - a), .tolerance = 1e-14});
    chapter.claim_at_most("3.2 furthest of t, b1, b2 from 90/31, 37/124, 49/124", furthest(hit), 1e-15);
}

/// 3.3  What can be computed before the ray is known?
void planes(course::Chapter& chapter) {
    chapter.section("3.3 The plane first");
    const auto hit = PlaneTriangle<double>(example).intersect(example_ray, in_front<double>).value();
    chapter.claim_at_most("3.3 furthest of t, b1, b2 from 90/31, 37/124, 49/124", furthest(hit), 1e-15);
}

/// 3.4  Where do rays slip through?
void edges(course::Chapter& chapter, const Target& sphere, const Target& pot) {
    chapter.section("3.4 Between two triangles");
    auto diagram = chapter.diagram("slit", "One edge, twice rounded and once");
    draw_slit(diagram);
    diagram.caption("Dashed: the edge as it is. Each triangle that rounds it for itself sees another one.");

    Found found;
    slits(chapter, sphere, At::edges, {{10.0, 9.7, 10.4, 10.3}, {8.9, 8.9, 9.2, 9.9}, {9.8, 9.3, 9.9, 10.0}},
          found);
    slits(chapter, pot, At::edges,
          {{12.3, 12.3, 17.8, 17.4}, {12.1, 12.1, 14.6, 14.4}, {12.5, 12.0, 17.4, 16.9}}, found);
    slits(chapter, sphere, At::vertices, {{8.3, 8.0, 1.2, 0.9}}, found);
    slits(chapter, pot, At::vertices, {}, found);
    chapter.claim("3.4 standard error of the least known share [%]",
                  {.expected = 0.19, .measured = found.standard_error, .tolerance = 0.005});
    chapter.claim("3.5 of 960 000 rays, attacks in which a watertight test lost any",
                  {.measured = double(found.leaky)});
    render_leaks(chapter, sphere, pot);
}

/// 3.6  What does it cost?
void cost(course::Chapter& chapter, const Target& sphere) {
    chapter.section("3.6 What it costs to be tight");
    auto       chart = chapter.chart("leaks", "Rays at the edges of a sphere: time and leaks", race_axes());
    const auto aimed = aims(sphere, At::edges, attack_side, {.threads = chapter.options().threads});
    race(chart, sphere, aimed, chapter.options());
    chapter.say(chart.data().table);

    const auto in_float    = t_errors<float>(placements.front());
    const auto in_double   = t_errors<double>(placements.front());
    double     least_known = 0;
    const auto claim = [&](const std::string& name, std::size_t method, double of_float, double of_double) {
        chapter.claim("3.6 mean error of t, float, " + name,
                      {.expected = of_float, .measured = in_float[method].mean(), .tolerance = 0.05e-8});
        chapter.claim("3.6 mean error of t, double, " + name,
                      {.expected = of_double, .measured = in_double[method].mean(), .tolerance = 0.05e-16});
        for (const auto& errors : {in_float[method], in_double[method]})
            least_known = max_or_nan(least_known, errors.standard_error() / errors.mean());
    };
    claim("Cramer", 0, 3.3e-8, 1.1e-16);
    claim("plane and edges", 1, 2.6e-8, 0.7e-16);
    claim("as published", 2, 4.2e-8, 0.8e-16);
    claim("watertight", 3, 4.1e-8, 0.8e-16);
    chapter.claim_at_most("3.6 standard error of these means, of the least known of them [%]",
                          100 * least_known, 6);
}

/// The largest y of a curve.
double worst(const course::Chart& chart, const std::string& series) {
    double most = 0;
    for (const auto& row : chart.data().table.rows)
        if (row[0].text() == series) most = max_or_nan(most, row[2].number());
    return most;
}

/// The largest standard error of a curve's y, as a share of that [%].
double least_known(const course::Chart& chart, const std::string& series) {
    double most = 0;
    for (const auto& row : chart.data().table.rows)
        if (row[0].text() == series) most = max_or_nan(most, 100 * row[3].number() / row[2].number());
    return most;
}

/// 3.7  What if there is hardly a triangle?
void hardly_a_triangle(course::Chapter& chapter) {
    chapter.section("3.7 Small, flat, thin");
    const auto small = chart_small_triangles(chapter);
    chapter.claim("3.7 of 4000 triangles of size 0.001, those that an epsilon of 1e-6 does not lose",
                  {.expected  = 1,
                   .measured  = small_triangles * (1 - small.at("epsilon $10^{-6}$", 1e-3) / 100),
                   .tolerance = 1e-6});
    chapter.claim("3.7 triangles missed without an epsilon, at the worst of the sizes [%]",
                  {.measured = worst(small, "no epsilon")});

    const Triangle<double> line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    const Ray<double>      down{{0.5, 0, 1}, {0, 0, -1}};
    const auto             textbook_hit = textbook::intersect(line, down, in_front<double>, 0.0);
    chapter.claim("3.7 hits at NaN of a triangle without area, written as what misses",
                  {.expected = 1, .measured = double(textbook_hit && std::isnan(textbook_hit->t))});
    chapter.claim("3.7 hits of it, written as what hits",
                  {.measured = double(intersect_moeller_trumbore(line, down, in_front<double>).has_value())});

    const auto needles = chart_needles(chapter);
    for (const auto& [ratio, error] : {std::pair{1e-3, 4.7e-5}, {1e-6, 4.6e-2}})
        chapter.claim(fmt::format("3.7 error of a needle's area by Heron, sides as {:.0e} to 1", ratio),
                      {.expected = error, .measured = needles.at("Heron", ratio), .tolerance = 0.01 * error});
    chapter.claim_at_most("3.7 standard error of the means by Heron, of the least known of them [%]",
                          least_known(needles, "Heron"), 4);
    chapter.claim_at_most("3.7 error of a needle's area by Kahan, at the worst of the shapes",
                          worst(needles, "Kahan"), 1e-7);

    const float ax = 1.0001F, ay = 1, bx = 1,
                by   = 0.9999F;  // a_x b_y - a_y b_x, the third component of a x b
    const float left = ax * by, right = ay * bx;
    chapter.claim("3.7 the component of a cross product, plainly", {.measured = double(left - right)});
    chapter.claim("3.7 the component of a cross product, by Kahan, negated",
                  {.expected  = 1.00033e-8,
                   .measured  = -double(difference_of_products(ax, by, ay, bx)),
                   .tolerance = 0.5e-13});
}

/// 3.8  Where do triangles come from?
void meshes(course::Chapter& chapter, const Target& sphere, const Target& pot) {
    chapter.section("3.8 Meshes, and where they stand");
    const auto vertices = std::ssize(sphere.mesh.vertices), faces = std::ssize(sphere.mesh.faces);
    chapter.claim("3.8 vertices of the sphere", {.expected = 266, .measured = double(vertices)});
    chapter.claim("3.8 edges of the sphere",
                  {.expected = 792, .measured = double(sphere.neighbours.edges())});
    chapter.claim("3.8 vertices - edges + faces",
                  {.expected = 2, .measured = double(vertices - sphere.neighbours.edges() + faces)});
    const double shared = double(pot.mesh.vertices.size() * sizeof(Vec3)) / double(pot.mesh.faces.size()) +
                          sizeof(Mesh<float>::Face);
    chapter.claim("3.8 bytes for each of the teapot's triangles, vertices shared",
                  {.expected = 18.2, .measured = shared, .tolerance = 0.05});
    chapter.claim("3.8 bytes for each, vertices not shared",
                  {.expected = 36, .measured = sizeof(Triangle<float>)});

    const auto far = chart_far_away(chapter);
    chapter.claim(
        "3.8 missed at 1e+02 sizes, float in the world, rays of 20 000",
        {.expected = 3, .measured = far_triangles / 100.0 * far.at("float, world", 1e2), .tolerance = 1e-6});
    for (const auto& [distance, share] : {std::pair{1e4, 1.1}, {1e6, 27.6}})
        chapter.claim(fmt::format("3.8 missed at {:.0e} sizes, float in the world [%]", distance),
                      {.expected = share, .measured = far.at("float, world", distance), .tolerance = 0.05});
    chapter.claim("3.8 standard error of that [%]",
                  {.expected  = 0.3,
                   .measured  = standard_error(far.at("float, world", 1e6), far_triangles),
                   .tolerance = 0.05});
    chapter.claim("3.8 missed at the worst of the distances, double in the world [%]",
                  {.measured = worst(far, "double, world")});
    chapter.claim("3.8 missed at the worst of the distances, float in local coordinates [%]",
                  {.measured = worst(far, "float, local")});
}

}  // namespace
}  // namespace sr

int main(int argc, char** argv) {
    using namespace sr;
    const course::Defaults defaults{.takes_seed = false};
    return course::run(argc, argv, "03_triangles", "Triangles", defaults, [](course::Chapter& chapter) {
        const auto sphere = sphere_from_inside();
        const auto pot    = teapot_from_outside();
        weights(chapter);
        cramer(chapter);
        planes(chapter);
        edges(chapter, sphere, pot);
        cost(chapter, sphere);
        hardly_a_triangle(chapter);
        meshes(chapter, sphere, pot);
    });
}
