/// @file teapot.cpp

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <locale>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "math/extremes.hpp"
#include "scene/teapot.hpp"

using namespace sr;

namespace {

using Point = Vector3<double>;
using Edge  = std::pair<std::uint32_t, std::uint32_t>;

/// How often each edge is run in each direction.
std::map<Edge, int> directed_edges(const Mesh<double>& mesh) {
    std::map<Edge, int> uses;
    for (const auto& [a, b, c] : mesh.faces) {
        for (const Edge& e : {Edge{a, b}, Edge{b, c}, Edge{c, a}}) ++uses[e];
    }
    return uses;
}

/// The edges that only one face has.
std::vector<Edge> open_edges(const std::map<Edge, int>& directed) {
    std::vector<Edge> open;
    for (const auto& [edge, uses] : directed) {
        if (!directed.contains({edge.second, edge.first})) open.push_back(edge);
    }
    return open;
}

/// Names of the teapot's parts in the order of its patches, with the direction in which a patch's faces look
/// on the average: along z, or to the side of the axis or of the plane y = 0 that the patch lies on.
struct PatchPlace {
    const char* part;
    bool        pole;      // level triangles fewer
    char        outwards;  // 'r'adially from the axis, 'u'p, 'd'own, to the 's'ide in y
};

std::vector<PatchPlace> patch_places() {
    std::vector<PatchPlace> places;
    for (const PatchPlace& p :
         {PatchPlace{"rim", false, 'u'}, PatchPlace{"body", false, 'r'}, PatchPlace{"body", false, 'r'},
          PatchPlace{"knob", true, 'u'}, PatchPlace{"lid", false, 'u'}, PatchPlace{"bottom", true, 'd'}}) {
        places.insert(places.end(), 4, p);
    }
    places.insert(places.end(), 4, {"handle", false, 's'});
    places.insert(places.end(), 4, {"spout", false, 's'});
    return places;
}

/// The end of a surface that a point lies on, as the control points have it.
std::string end_at(Point p) {
    const auto near = [](double x, double y) { return std::abs(x - y) <= 0.01; };
    if (near(p.z, 2.4) && near(std::hypot(p.x, p.y), 1.4)) return "rim, inside";
    if (near(p.z, 2.4) && near(std::hypot(p.x, p.y), 1.3)) return "lid";
    if (near(p.z, 2.4) && p.x > 2.5) return "spout, lip";
    if (near(p.x, 1.7)) return "spout, in the body";
    if (p.x < -1.4 && p.x > -1.7 && p.z > 1.9) return "handle, above";
    if (p.x < -1.8 && p.x > -2.1 && p.z < 1) return "handle, below";
    return "crack";
}

double signed_volume(const Mesh<double>& mesh) {
    double six_volumes = 0;
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
        const auto [a, b, c] = mesh.triangle(i);
        six_volumes += dot(a, cross(b, c));
    }
    return six_volumes / 6;
}

}  // namespace

TEST_CASE("teapot: as many triangles and vertices as 32 patches without poles and seams leave") {
    for (const std::size_t n : {2u, 3u, 5u, 10u, 40u}) {
        CAPTURE(n);
        const Mesh<double> mesh = teapot(int(n));
        CHECK(mesh.faces.size() == 64 * n * n - 8 * n);
        // rings of 4 n around the axis: 4 n of the body and 2 n of the lid, and two poles; rings of 2 n: 2 n + 1 each
        // of handle and spout; the foot of the handle ends in a vertex of the body
        CHECK(mesh.vertices.size() == 6 * n * 4 * n + 2 + 2 * (2 * n + 1) * 2 * n - 1);
    }
    CHECK(teapot(1).faces.size() == 52);
}

TEST_CASE("teapot: a level that is no level is refused") {
    CHECK_THROWS_AS(static_cast<void>(teapot(0)), std::invalid_argument);
    CHECK_THROWS_AS(static_cast<void>(teapot(-3)), std::invalid_argument);
    CHECK_THROWS_WITH(static_cast<void>(teapot(501)), "teapot level 501: must be 1 to 500");
}

TEST_CASE("teapot: bounds") {
    const Mesh<double> mesh = teapot(40);
    Point              low = mesh.vertices[0], high = low;
    for (const Point& p : mesh.vertices) {
        low  = glm::min(low, p);
        high = glm::max(high, p);
    }
    CHECK(low == Point{-3, -2, 0});  // the handle's back, the body, the bottom
    CHECK(high.y == 2);
    CHECK(high.z == 3.15);  // the tip of the lid
    // the lip of the spout: the largest of 3.3 t^3 + 3 * 3.525 t^2 s + 3 * 3.45 t s^2 + 3.2 s^3
    CHECK(std::abs(high.x - 3.4342) <= 5e-4);
}

TEST_CASE("teapot: every edge has two faces, in opposite directions, but at the six ends of the surfaces") {
    for (const std::size_t n : {2u, 3u, 4u, 7u, 10u, 16u}) {
        CAPTURE(n);
        const Mesh<double> mesh     = teapot(int(n));
        const auto         directed = directed_edges(mesh);
        const auto         multiple =
            std::count_if(directed.begin(), directed.end(), [](const auto& e) { return e.second != 1; });
        CHECK(multiple == 0);

        std::map<std::string, std::size_t> ends;
        for (const auto& [from, to] : open_edges(directed)) {
            const std::string end = end_at(mesh.vertices[from]);
            ++ends[end == end_at(mesh.vertices[to]) ? end : "crack"];
        }
        const std::map<std::string, std::size_t> expected{
            {"rim, inside", 4 * n},        {"lid", 4 * n},           {"spout, lip", 2 * n},
            {"spout, in the body", 2 * n}, {"handle, above", 2 * n}, {"handle, below", 2 * n}};
        CHECK(ends == expected);
    }
}

TEST_CASE("teapot: a seam that misses by a bit would show") {
    Mesh<double> mesh = teapot(3);
    const auto   open = open_edges(directed_edges(mesh)).size();
    CHECK(open == 16 * 3);
    // a corner of a face gets a vertex of its own, a bit away
    mesh.vertices.push_back(mesh.vertices[mesh.faces[100][0]] + Point{1e-16, 0, 0});
    mesh.faces[100][0] = std::uint32_t(mesh.vertices.size() - 1);
    CHECK(open_edges(directed_edges(mesh)).size() == open + 4);
}

TEST_CASE("teapot: each of the 32 patches looks outwards, the mirrored ones too") {
    const int          n      = 8;
    const Mesh<double> mesh   = teapot(n);
    const auto         places = patch_places();
    REQUIRE(places.size() == 32);

    std::size_t face = 0;
    for (const PatchPlace& patch : places) {
        CAPTURE(patch.part);
        CAPTURE(face);
        Point             total{};  // area vector
        Point             middle{};
        double            away_from_axis = 0;
        const std::size_t end            = face + std::size_t(2 * n * n - (patch.pole ? n : 0));
        for (; face < end; ++face) {
            const Triangle<double> t = mesh.triangle(face);
            total += area_vector(t);
            middle += t.a;
            away_from_axis += dot(area_vector(t), Point{t.a.x, t.a.y, 0});
        }
        if (patch.outwards == 'r') CHECK(away_from_axis > 0);
        if (patch.outwards == 'u') CHECK(total.z > 0);
        if (patch.outwards == 'd') CHECK(total.z < 0);
        if (patch.outwards == 's') CHECK(total.y * middle.y > 0);
    }
    CHECK(face == mesh.faces.size());
    // the edges' directions, checked above, spread this from patches to faces
    CHECK(signed_volume(mesh) > 15);
}

TEST_CASE("teapot: no face without an area, no two vertices at nearly one place") {
    for (const int n : {1, 2, 5, 16}) {
        CAPTURE(n);
        const Mesh<double> mesh  = teapot(n);
        double             least = 1;
        for (std::size_t i = 0; i < mesh.faces.size(); ++i) least = min_or_nan(least, area(mesh.triangle(i)));
        CHECK(least >= 1e-5 / n / n);

        // sorted by x, neighbours within a small distance in x are few
        std::vector<Point> sorted = mesh.vertices;
        std::sort(sorted.begin(), sorted.end(), [](const Point& a, const Point& b) { return a.x < b.x; });
        double nearest = 1;
        for (std::size_t i = 0; i < sorted.size(); ++i) {
            for (std::size_t k = i + 1; k < sorted.size() && sorted[k].x - sorted[i].x <= 1e-6; ++k) {
                nearest = min_or_nan(nearest, length(sorted[k] - sorted[i]));
            }
        }
        CHECK(nearest >= 1e-4);
    }
}

TEST_CASE("teapot: it is its own image under y -> -y") {
    using Key               = std::array<double, 3>;
    const Mesh<double> mesh = teapot(6);
    std::set<Key>      positions;
    for (const Point& p : mesh.vertices) positions.insert({p.x, p.y, p.z});
    std::size_t found = 0;
    for (const Point& p : mesh.vertices) found += positions.count({p.x, -p.y, p.z});
    CHECK(positions.size() == mesh.vertices.size());
    CHECK(found == mesh.vertices.size());
}

TEST_CASE("teapot: the same where the decimal point is a comma") {
    struct Comma : std::numpunct<char> {
        [[nodiscard]] char do_decimal_point() const override { return ','; }
    };
    const Mesh<double> expected = teapot(2);
    const std::locale  before   = std::locale::global(std::locale(std::locale::classic(), new Comma));
    const Mesh<double> mesh     = teapot(2);
    std::locale::global(before);
    CHECK(mesh.vertices == expected.vertices);
    CHECK(mesh.faces == expected.faces);
}

TEST_CASE("teapot: a million triangles, welded all the same") {
    const Mesh<double> mesh = teapot(125);
    CHECK(mesh.faces.size() == 64 * 125 * 125 - 8 * 125);
    CHECK(mesh.vertices.size() == 32 * 125 * 125 + 4 * 125 + 1);
    std::uint32_t largest = 0;
    for (const auto& face : mesh.faces) largest = std::max({largest, face[0], face[1], face[2]});
    CHECK(largest == mesh.vertices.size() - 1);
}
