/// @file cornell_box.cpp

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <span>
#include <string>
#include <utility>

#include "scene/cornell_box.hpp"

using namespace sr;

namespace {

using Point = Vector3<double>;

/// A part of the box: its faces in the file, and the area that its corners give by the trapezoid rule.
struct Part {
    const char* name;
    std::size_t first, end;
    double      area;
    const char* material;
};

/// Blocks: the top by the shoelace formula in x and z, and sides as wide as the top's edges.
double block_area(std::span<const Point> top) {
    double area = 0;
    for (std::size_t i = 0; i < top.size(); ++i) {
        const Point a = top[i];
        const Point b = top[(i + 1) % top.size()];
        area += (a.z * b.x - b.z * a.x) / 2 + a.y * std::hypot(b.x - a.x, b.z - a.z);
    }
    return area;
}

const std::array<Point, 4> short_top{{{130, 165, 65}, {82, 165, 225}, {240, 165, 272}, {290, 165, 114}}};
const std::array<Point, 4> tall_top{{{423, 330, 247}, {265, 330, 296}, {314, 330, 456}, {472, 330, 406}}};

/// Without the red wall, which is not planar.
const std::array<Part, 7> parts{{{"floor", 0, 2, (552.8 + 549.6) / 2 * 559.2, "white"},
                                 {"ceiling", 2, 4, 556 * 559.2, "white"},
                                 {"back wall", 4, 6, (549.6 + 556) / 2 * 548.8, "white"},
                                 {"right wall", 6, 8, 559.2 * 548.8, "green"},
                                 {"light", 10, 12, 130 * 105, "light"},
                                 {"short block", 12, 22, block_area(short_top), "white"},
                                 {"tall block", 22, 32, block_area(tall_top), "white"}}};

double area_of(const Mesh<double>& mesh, std::size_t first, std::size_t end) {
    double sum = 0;
    for (std::size_t i = first; i < end; ++i) sum += area(mesh.triangle(i));
    return sum;
}

double relative_error(double measured, double expected) {
    return std::abs(measured - expected) / expected;
}

}  // namespace

TEST_CASE("cornell box: parts have the areas and paints of the published measurements") {
    const Scene box = cornell_box();
    CHECK(box.mesh.faces.size() == 32);
    CHECK(box.material_of_face.size() == 32);
    CHECK(box.materials.size() == 4);
    for (const Part& part : parts) {
        CAPTURE(part.name);
        CHECK(relative_error(area_of(box.mesh, part.first, part.end), part.area) <= 1e-14);
        for (std::size_t i = part.first; i < part.end; ++i) {
            CHECK(box.materials.at(box.material_of_face[i]).name == part.material);
        }
    }
    CHECK(box.materials.at(box.material_of_face[8]).name == "red");
    CHECK(box.materials.at(box.material_of_face[9]).name == "red");
}

TEST_CASE("cornell box: the paints' reflectances") {
    const std::map<std::string, Spectrum> paints{{"white", {0.725F, 0.71F, 0.68F}},
                                                 {"red", {0.63F, 0.065F, 0.05F}},
                                                 {"green", {0.14F, 0.45F, 0.091F}},
                                                 {"light", {0.78F, 0.78F, 0.78F}}};
    std::set<std::string>                 seen;
    for (const Material& m : cornell_box().materials) {
        CAPTURE(m.name);
        REQUIRE(paints.contains(m.name));
        CHECK(m.reflectance() == paints.at(m.name));
        CHECK((m.emission == Spectrum{}) == (m.name != "light"));
        seen.insert(m.name);
    }
    CHECK(seen.size() == paints.size());
}

TEST_CASE("cornell box: the red wall is not planar, and is cut as (0,1,2), (0,2,3)") {
    const Scene                box = cornell_box();
    const std::array<Point, 4> corner{
        {{552.8, 0, 0}, {549.6, 0, 559.2}, {556, 548.8, 559.2}, {556, 548.8, 0}}};
    const auto             close = [](Point a, Point b) { return length(a - b) <= 1e-12; };
    const Triangle<double> first = box.mesh.triangle(8), second = box.mesh.triangle(9);
    CHECK(close(first.a, corner[0]));
    CHECK(close(first.b, corner[1]));
    CHECK(close(first.c, corner[2]));
    CHECK(close(second.a, corner[0]));
    CHECK(close(second.b, corner[2]));
    CHECK(close(second.c, corner[3]));

    // computed apart from this program from the published corners
    const Point n = normalize(area_vector(first));
    CHECK(std::abs(std::abs(dot(n, corner[3] - corner[0])) - 3.1997300432655346) <= 1e-12);
    CHECK(std::abs(length((corner[0] + corner[2]) / 2.0 - (corner[1] + corner[3]) / 2.0) - 1.6) <= 1e-12);
}

TEST_CASE("cornell box: walls and light face the room, blocks face outwards") {
    const Scene box = cornell_box();
    const Point middle_of_room{277, 274, 280};
    const auto  faces_towards = [&](std::size_t face, Point p) {
        const Triangle<double> t = box.mesh.triangle(face);
        return dot(area_vector(t), p - t.a) > 0;
    };
    for (std::size_t i = 0; i < 12; ++i) {
        CAPTURE(i);
        CHECK(faces_towards(i, middle_of_room));
    }
    for (std::size_t i = 12; i < 32; ++i) {
        CAPTURE(i);
        const auto& top = i < 22 ? short_top : tall_top;
        CHECK(!faces_towards(i, (top[0] + top[1] + top[2] + top[3]) / 4.0 - Point{0, 10, 0}));
    }
    for (const std::size_t i : {std::size_t{10}, std::size_t{11}}) {
        const Point n = normalize(area_vector(box.mesh.triangle(i)));
        CHECK(length(n - Point{0, -1, 0}) <= 1e-15);
    }
}

TEST_CASE("cornell box: each block is closed but for the floor that it stands on") {
    using Key       = std::array<double, 3>;
    const Scene box = cornell_box();
    for (const Part& block : std::span(parts).last(2)) {
        CAPTURE(block.name);
        std::map<std::pair<Key, Key>, int> edges;  // +1 along, -1 against
        for (std::size_t i = block.first; i < block.end; ++i) {
            const auto [a, b, c] = box.mesh.triangle(i);
            for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}}) {
                const Key p{from.x, from.y, from.z}, q{to.x, to.y, to.z};
                p < q ? ++edges[{p, q}] : --edges[{q, p}];
            }
        }
        int open = 0;
        for (const auto& [edge, balance] : edges) {
            if (balance == 0) continue;
            ++open;
            CHECK(std::abs(balance) == 1);
            CHECK(edge.first[1] == 0);
            CHECK(edge.second[1] == 0);
        }
        CHECK(open == 4);
    }
}

TEST_CASE("cornell box: the light's flux is pi L A") {
    const Scene           box = cornell_box();
    std::array<double, 3> flux{};
    for (std::size_t i = 0; i < box.mesh.faces.size(); ++i) {
        const Spectrum L = box.materials.at(box.material_of_face[i]).emission;
        const double   A = area(box.mesh.triangle(i));
        flux[0] += std::numbers::pi * double(L.r) * A;
        flux[1] += std::numbers::pi * double(L.g) * A;
        flux[2] += std::numbers::pi * double(L.b) * A;
    }
    CHECK(relative_error(flux[0], std::numbers::pi * 17 * 130 * 105) <= 1e-14);
    CHECK(relative_error(flux[1], std::numbers::pi * 12 * 130 * 105) <= 1e-14);
    CHECK(relative_error(flux[2], std::numbers::pi * 4 * 130 * 105) <= 1e-14);
    for (std::size_t i : {std::size_t{10}, std::size_t{11}})
        CHECK(std::abs(box.mesh.triangle(i).a.y - 548.7) <= 1e-12);
}
