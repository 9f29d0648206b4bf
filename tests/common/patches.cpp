/// @file patches.cpp
/// Surfaces cut into patches: no area is lost, nothing lies beside its polygon, and what radiosity can't do is refused.

#include "radiosity/patches.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <set>

#include "../../chapters/08_radiosity/slivers.hpp"
#include "near.hpp"
#include "patch_shapes.hpp"
#include "radiosity/exchange_area.hpp"
#include "radiosity/vertex_radiosity.hpp"
#include "radiosity/visibility.hpp"
#include "refusal.hpp"
#include "scene/cornell_box.hpp"

using namespace sr;
using sr::test::grey;
using sr::test::near;

namespace {

using Point = Vector3<double>;

const Patch trapezoid{{0, 0, 0}, {4, 0, 0}, {2, 1, 0}, {0, 1, 0}};
const Patch quadrilateral{{0, 0, 0}, {4, 0, 0}, {3, 2, 0}, {0, 1, 0}};
const Patch triangle{{0, 0, 0}, {3, 0, 0}, {0, 1.5, 0}};

double area_of(const Patches& patches) {
    return std::accumulate(patches.shapes.begin(), patches.shapes.end(), 0.0,
                           [](double sum, const Patch& shape) { return sum + shape.area(); });
}

/// The mean of x over points of a patch for u on a fine grid.
double mean_x(const std::function<Point(Vector2<double>)>& point) {
    constexpr int n   = 512;
    double        sum = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) sum += point({(i + 0.5) / n, (j + 0.5) / n}).x;
    return sum / (n * n);
}

/// Two triangles with z = height at the fourth corner, of one diffuse material.
Scene square(double height = 0) {
    return {.mesh             = {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, height}}, {{0, 1, 2}, {0, 2, 3}}},
            .materials        = {diffuse_material("paint", {0.5F, 0.25F, 0.125F}, {1, 2, 3})},
            .material_of_face = {0, 0}};
}

std::string refusal(const Scene& scene) {
    return sr::test::refusal_of([&] { (void)polygons_of(scene); });
}

}  // namespace

TEST_CASE("a patch without an area, or four corners that are not flat and convex, is refused, and named") {
    const Point  a{0, 0, 0}, b{1, 0, 0}, c{1, 1, 0}, d{0, 1, 0};
    const double none = std::nan(""), far = std::numeric_limits<double>::infinity();
    CHECK_THROWS_WITH_AS(
        Patch(a, b, Point{2, 0, 0}),
        "the patch with the corners (0, 0, 0) (1, 0, 0) (2, 0, 0) has no area; its corners must "
        "not lie on one line",
        std::invalid_argument);
    CHECK_THROWS_AS(Patch(a, b, b), std::invalid_argument);
    CHECK_THROWS_AS(Patch(a, b, Point{1, none, 0}), std::invalid_argument);
    CHECK_THROWS_AS(Patch(a, b, Point{1, far, 0}), std::invalid_argument);
    CHECK_THROWS_AS(Patch(a, b, Point{2, 0, 0}, Point{3, 0, 0}), std::invalid_argument);
    CHECK_THROWS_AS(Patch(a, b, c, Point{0, none, 0}), std::invalid_argument);
    CHECK_THROWS_WITH_AS(
        Patch(a, b, Point{0.25, 0.25, 0}, d),  // turned inwards
        "the patch with the corners (0, 0, 0) (1, 0, 0) (0.25, 0.25, 0) (0, 1, 0) is no flat convex "
        "quadrilateral; make it two triangles",
        std::invalid_argument);
    CHECK_THROWS_AS(Patch(a, c, b, d), std::invalid_argument);  // its sides cross
    CHECK_THROWS_AS(Patch(a, b, Point{1, 1, 1e-3}, d), std::invalid_argument);
    CHECK_THROWS_AS(Patch(a, b, Point{1, 1, 2e-6}, d), std::invalid_argument);
}

TEST_CASE(
    "a patch may be off its plane as files are rounded, have a corner on a side, and be narrow and far "
    "away") {
    const Point a{0, 0, 0}, b{1, 0, 0}, d{0, 1, 0};
    CHECK(Patch(a, b, {1, 1, 1e-6}, d).area() == near(1, 1e-6));
    CHECK(Patch(a, b, {0.5, 0.5, 0}, d).area() == near(0.5, 1e-14));
    for (const double width : {1e-3, 1e-8, 1e-11}) {
        CAPTURE(width);
        const auto at = [&](double s, double t) {
            return Point{100, 50, 20} + s * normalize(Point{1, 2, 0}) +
                   t * width * normalize(Point{2, -1, 3});
        };
        const Patch narrow(at(0, 0), at(1, 0), at(1, 1), at(0, 1));
        CHECK(narrow.area() == near(width, 1e-13 / width));  // corners are rounded to 100 / 2^53
        for (const auto& quarter : narrow.quarters()) CHECK(quarter.area() == near(width / 4, 1e-13 / width));
        CHECK(narrow.reversed().area() == near(width, 1e-13 / width));
    }
}

TEST_CASE("a patch has the area, the centre and the normal of its corners") {
    CHECK(trapezoid.area() == near(3, 1e-15));
    CHECK(trapezoid.centre().x ==
          near(14.0 / 9, 1e-15));  // strips of width 4 - 2y: 1/3 int (4 - 2y)^2 / 2 dy
    CHECK(trapezoid.centre().y == near(4.0 / 9, 1e-15));
    CHECK(trapezoid.longest_side() == 4);
    CHECK(triangle.area() == near(2.25, 1e-15));
    CHECK(triangle.centre() == Point{1, 0.5, 0});
    for (const Patch& patch : {trapezoid, triangle}) {
        CHECK(patch.normal() == Point{0, 0, 1});
        CHECK(patch.reversed().normal() == Point{0, 0, -1});
        CHECK(patch.reversed().area() == patch.area());
        double area = 0;
        for (const auto& quarter : patch.quarters()) {
            CHECK(quarter.normal() == patch.normal());
            area += quarter.area();
        }
        CHECK(area == near(patch.area(), 1e-15));
    }
    for (const auto& quarter : triangle.quarters()) CHECK(quarter.area() == near(2.25 / 4, 1e-15));
}

TEST_CASE("points of a patch are uniform in its area, which those of the bilinear map are not") {
    for (const Patch& patch : {trapezoid, quadrilateral, triangle}) {
        const double expected = patch.centre().x;
        CHECK(mean_x([&](auto u) { return patch.sample(u); }) == near(expected, 1e-5));
        CHECK(mean_x([&](auto u) { return patch.at(u); }) != near(expected, 0.02));
    }
    const Patch square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    CHECK(length(square.sample({0.25, 0.75}) - Point{0.25, 0.75, 0}) <= 1e-15);
    CHECK(length(triangle.sample({0, 1}) - triangle.corners()[2]) <= 1e-15);
    CHECK(length(triangle.sample({0, 0})) <= 1e-15);
}

TEST_CASE("what is cut keeps its area, and no side is longer than asked for") {
    for (const Patch& shape : {trapezoid, triangle}) {
        for (const double size : {10.0, 1.0, 0.3, 0.07}) {
            CAPTURE(size);
            const std::vector<Polygon> polygons{grey(shape)};
            const Patches              patches = cut(polygons, size);
            CHECK(area_of(patches) == near(shape.area(), 1e-12));
            double longest = 0;
            for (std::size_t i = 0; i < patches.size(); ++i) {
                const auto corners = patches.shapes[i].corners();
                longest            = std::max(longest, patches.shapes[i].longest_side());
                CHECK(patches.shapes[i].normal().z == near(1, 1e-12));
                for (std::size_t k = 0; k < corners.size(); ++k)
                    CHECK(corners[k] == patches.vertices[patches.corners[i][k]]);
            }
            CHECK(longest <= std::min(size, shape.longest_side()) * (1 + 1e-12));
        }
    }
    CHECK(cut(std::vector{grey(triangle)}, 3.4).size() == 1);
    CHECK(cut(std::vector{grey(triangle)}, triangle.longest_side() / 5).size() == 25);
    CHECK(cut(std::vector{grey(trapezoid)}, 1).size() == 4 * 3);  // its slanting side is sqrt(5) long
}

TEST_CASE("patches share their vertices with their neighbours, and their triangles cover them") {
    const Patches patches = cut(std::vector{grey(trapezoid), grey(triangle)}, 0.5);
    const auto    seen    = mesh_of(patches);
    double        sum     = 0;
    for (std::size_t i = 0; i < seen.mesh.faces.size(); ++i) sum += area(seen.mesh.triangle(i));
    CHECK(sum == near(trapezoid.area() + triangle.area(), 1e-12));
    CHECK(std::set<std::uint32_t>(seen.patch_of_face.begin(), seen.patch_of_face.end()).size() ==
          patches.size());
    CHECK(patches.polygon.back() == 1);
    const Patches four = cut(std::vector{grey(Patch{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}})}, 0.5);
    CHECK(four.size() == 4);
    CHECK(four.vertices.size() == 9);
}

TEST_CASE(
    "of slivers as narrow as their corners' rounding, pieces with an area are patches, and others none") {
    const auto wall_over = [](const Sliver& sliver) {
        const auto at = [&](double t, double z) { return sliver.centre + sliver.frame.to_world({0, t, z}); };
        return Patch{at(-1, -1), at(1, -1), at(1, 1), at(-1, 1)};
    };
    int left_out = 0;
    for (const double width : {1e-12, 1e-13, 3e-14, 1e-14})
        for (int k = 0; k < 50; ++k) {
            CAPTURE(width);
            CAPTURE(k);
            const Sliver sliver = any_sliver(k);
            const auto   at     = [&](double s, double t) {
                return sliver.centre + sliver.frame.to_world({s, width * t, 0});
            };
            Scene scene         = square();
            scene.mesh.vertices = {at(0, 0), at(1, 0), at(1, 1), at(0, 1)};
            const auto    both  = polygons_of(scene, ShiningSides::both);
            const Patches whole = cut(both, 2), cut_small = cut(both, 0.3);
            for (const auto& shape : whole.shapes)  // to a wall over its end, where it is quartered
                CHECK(std::isfinite(exchange_area(shape, wall_over(sliver))));
            for (const auto& B : vertex_radiosities(cut_small, Radiosities(cut_small.size(), {1, 2, 3})))
                CHECK(is_finite(B));
            std::size_t pieces = 0;
            for (const auto& polygon : both) pieces += polygon.shape.corners().size() == 3 ? 16 : 4;
            CHECK(cut_small.size() <= pieces);
            if (cut_small.size() < pieces) ++left_out;
        }
    CHECK(left_out > 50);
}

TEST_CASE("two triangles are one quadrilateral if they are flat; else they stay two") {
    const auto flat = polygons_of(square());
    REQUIRE(flat.size() == 1);
    CHECK(flat[0].shape.corners().size() == 4);
    CHECK(flat[0].shape.area() == near(1, 1e-15));
    CHECK(flat[0].reflectance == DoubleSpectrum{0.5, 0.25, 0.125});
    CHECK(flat[0].emission.b == near(3 * 3.14159265358979324, 1e-15));
    CHECK(polygons_of(square(0.01)).size() == 2);

    Scene dart            = square();  // not convex
    dart.mesh.vertices[1] = {0.4, 0.6, 0};
    dart.mesh.faces       = {{3, 0, 1}, {3, 1, 2}};
    CHECK(polygons_of(dart).size() == 2);

    Scene two_colours            = square();
    two_colours.materials        = {diffuse_material("red", {0.5F, 0, 0}, {}),
                                    diffuse_material("blue", {0, 0, 0.5F}, {})};
    two_colours.material_of_face = {0, 1};
    const auto halves            = polygons_of(two_colours);
    REQUIRE(halves.size() == 2);
    CHECK(halves[0].reflectance == DoubleSpectrum{0.5, 0, 0});
    CHECK(halves[1].reflectance == DoubleSpectrum{0, 0, 0.5});

    Scene part = square();  // the second triangle is half of what would make the first one a square
    part.mesh.vertices.emplace_back(0.5, 1, 0);
    part.mesh.faces       = {{0, 1, 2}, {0, 4, 3}};
    const auto with_a_gap = polygons_of(part);
    REQUIRE(with_a_gap.size() == 2);
    CHECK(with_a_gap[1].shape.area() == near(0.25, 1e-15));

    const auto both = polygons_of(square(), ShiningSides::both);
    REQUIRE(both.size() == 2);
    CHECK(both[1].shape.normal() == Point{0, 0, -1});
}

TEST_CASE("the Cornell box is 16 quadrilaterals and the red wall's two triangles") {
    const auto polygons = polygons_of(cornell_box());
    const auto quads    = std::count_if(polygons.begin(), polygons.end(),
                                        [](const Polygon& p) { return p.shape.corners().size() == 4; });
    CHECK(polygons.size() - std::size_t(quads) == 2);
    double      area_of_faces = 0, area_of_polygons = 0;
    const Scene box = cornell_box();
    for (std::size_t i = 0; i < box.mesh.faces.size(); ++i) area_of_faces += area(box.mesh.triangle(i));
    for (const auto& polygon : polygons) area_of_polygons += polygon.shape.area();
    CHECK(area_of_polygons == near(area_of_faces, 1e-14));
}

TEST_CASE("faces without an area are left out, and what radiosity can't do is refused by name") {
    Scene flat = square();
    flat.mesh.faces.push_back({0, 1, 1});
    flat.material_of_face.push_back(0);
    CHECK(polygons_of(flat).size() == 1);

    Scene mirror     = square();
    mirror.materials = {{"chrome", LobeSum<float>{{{{0.5F, 0.5F, 0.5F}, Mirror<float>{}}}}}};
    CHECK(refusal(mirror).find("material 'chrome' is not diffuse") == 0);
    Scene dull     = square();  // a lobe that reflects nothing may be anything
    dull.materials = {
        {"paint", LobeSum<float>{{{{0, 0, 0}, Mirror<float>{}}, {{0.5F, 0.5F, 0.5F}, Diffuse<float>{}}}}}};
    CHECK(refusal(dull) == "accepted");
    CHECK(polygons_of(dull)[0].reflectance == DoubleSpectrum{0.5, 0.5, 0.5});
    Scene ball = square();
    ball.balls.push_back({{{0, 0, 1}, 0.5}, 0});
    CHECK(refusal(ball).find("has balls") != std::string::npos);
    Scene lit = square();
    lit.lights.push_back({{0, 0, 1}, {1, 1, 1}});
    CHECK(refusal(lit).find("has point lights") != std::string::npos);
    Scene sky      = square();
    sky.background = {1, 1, 1};
    CHECK(refusal(sky).find("background") != std::string::npos);
    CHECK(refusal(Scene{}).find("has none") != std::string::npos);

    const std::vector<Polygon> one{grey(triangle)};
    for (const double size : {0.0, -1.0, std::nan(""), 1e-9}) {
        CAPTURE(size);
        CHECK_THROWS_AS((void)cut(one, size), std::invalid_argument);
    }
}

TEST_CASE("points of patches see each other unless a face lies between them") {
    const Patch      floor{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const Patch      roof{{0, 0, 2}, {0, 1, 2}, {1, 1, 2}, {1, 0, 2}};
    Scene            scene = square();
    const Visibility open{scene.mesh};
    const auto       from = [](const Patch& patch, double x, double y) {
        return patch.surface_point(patch.at({x, y}));
    };
    CHECK(open.between(from(floor, 0.3, 0.4), from(roof, 0.9, 0.1)));
    for (auto& vertex : scene.mesh.vertices)
        vertex = vertex / 2.0 + Point{0, 0, 1};  // over a quarter of the floor
    const Visibility shaded{scene.mesh};
    CHECK(!shaded.between(from(floor, 0.2, 0.2), from(roof, 0.2, 0.2)));
    CHECK(!shaded.between(from(roof, 0.2, 0.2), from(floor, 0.2, 0.2)));
    CHECK(shaded.between(from(floor, 0.8, 0.8), from(roof, 0.8, 0.8)));
}
