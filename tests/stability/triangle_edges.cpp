/// @file triangle_edges.cpp
/// Rays aimed at an edge that two triangles share: none may pass between them (catalogue rows S10, S11).

#include <doctest/doctest.h>

#include <cmath>
#include <optional>

#include "../../chapters/03_triangles/attack.hpp"
#include "catalogue.hpp"
#include "geometry/hierarchy.hpp"
#include "geometry/moeller_trumbore.hpp"
#include "sampling/rng.hpp"
#include "scene/uv_sphere.hpp"

using namespace sr;
using test::within_factor_3;

namespace {

/// Two triangles a, b, c and b, a, d, and a ray at a point of the edge from a to b that is as near to it as T says.
template <class T>
struct EdgePair {
    Triangle<T> first, second;
    Ray<T>      ray;
};

/// What the pairs of an attack are like.
struct Pairs {
    double offset = 0;  ///< added to all coordinates
    double height = 0;  ///< of c and d above the edge; 0: of any size
};

/// A point above the edge, or with its opposite sign below it.
Vector3<double> beside(Rng& rng, Vector3<double> a, Vector3<double> b, double height) {
    const auto along = normalize(b - a), somewhere = in_cube(rng);
    const auto middle = a + (0.25 + 0.5 * rng.uniform<double>()) * (b - a);
    return middle + height * normalize(somewhere - dot(somewhere, along) * along);
}

/// None where the ray does not see c and d on opposite sides of the edge, with some room.
template <class T>
std::optional<EdgePair<T>> edge_pair(Rng& rng, Pairs pairs) {
    const auto   a = in_cube(rng), b = in_cube(rng), origin = 0.5 * in_cube(rng);
    const auto   c      = pairs.height > 0 ? beside(rng, a, b, pairs.height) : in_cube(rng);
    const auto   d      = pairs.height > 0 ? beside(rng, a, b, pairs.height) : in_cube(rng);
    const auto   n      = normalize(cross(a - origin, b - origin));
    const double room   = 0.1 * (pairs.height > 0 ? pairs.height : 1);
    const double side_c = dot(n, c - origin), side_d = dot(n, d - origin);
    if (!(side_c * side_d < 0 && std::abs(side_c) > room && std::abs(side_d) > room)) return std::nullopt;

    const auto       rounded = [&](Vector3<double> p) { return Vector3<T>(p + pairs.offset); };
    const Vector3<T> ta = rounded(a), tb = rounded(b), to = rounded(origin);
    const T          u = T(0.05) + T(0.9) * rng.uniform<T>();  // not beyond the ends, after rounding
    return EdgePair<T>{{ta, tb, rounded(c)}, {tb, ta, rounded(d)}, {to, ta + u * (tb - ta) - to}};
}

/// Which share of 200 000 rays [%] passes between the two triangles.
template <class T>
double percent_leaking(Pairs pairs, const auto& hits) {
    constexpr int rays = 200'000;
    int           lost = 0;
    Rng           rng{10, 0, 0, 0};
    for (int asked = 0; asked < rays;) {
        const auto pair = edge_pair<T>(rng, pairs);
        if (!pair) continue;
        ++asked;
        lost += hits(pair->first, pair->ray) || hits(pair->second, pair->ray) ? 0 : 1;
    }
    return 100.0 * lost / rays;
}

constexpr auto textbook = []<class T>(const Triangle<T>& triangle, const Ray<T>& ray) {
    return intersect_moeller_trumbore(triangle, ray, in_front<T>).has_value();
};
constexpr auto watertight = []<class T>(const Triangle<T>& triangle, const Ray<T>& ray) {
    return TriangleRay<T>(ray).intersect(triangle, in_front<T>).has_value();
};

/// The UV sphere of 528 triangles in another place and size; flattened, a lens of needles.
template <class T>
struct Globe {
    double          scale;
    Vector3<double> centre;
    double          flat = 1;
    Mesh<T>         mesh = placed();

    Mesh<T> placed() const {
        auto exact = uv_sphere(12);
        for (auto& vertex : exact.vertices)
            vertex = scale * Vector3<double>{vertex.x, vertex.y, flat * vertex.z} + centre;
        return convert<T>(exact);
    }

    /// From inside at a vertex, one in four, or at a point of an edge.
    Ray<T> aimed(Rng& rng) const {
        const Vector3<T> origin(centre + 0.3 * scale * Vector3<double>{1, 1, flat} * in_cube(rng));
        const auto   triangle = mesh.triangle(std::size_t(rng.uniform<double>() * double(mesh.faces.size())));
        const double u        = rng.uniform() < 0.25F ? 0 : rng.uniform<double>();
        const Vector3<double> a(triangle.a), b(triangle.b);
        return {origin, Vector3<T>(a + u * (b - a) - Vector3<double>(origin))};
    }

    /// From inside anywhere.
    Ray<T> anywhere(Rng& rng) const { return {Vector3<T>(centre), Vector3<T>(in_cube(rng))}; }
};

bool textbook_hits(const Mesh<float>& mesh, const Ray<float>& ray) {
    for (std::size_t face = 0; face < mesh.faces.size(); ++face)
        if (textbook(mesh.triangle(face), ray)) return true;
    return false;
}

}  // namespace

TEST_CASE("S10 a ray at a shared edge passes between the textbook's triangles, not between watertight ones") {
    CHECK(within_factor_3(percent_leaking<float>({}, textbook), 5.458));
    CHECK(within_factor_3(percent_leaking<float>({.offset = 100}, textbook), 0.036));
    CHECK(within_factor_3(percent_leaking<float>({.height = 1e-3}, textbook), 5.347));
    CHECK(within_factor_3(percent_leaking<double>({}, textbook), 4.877));
    for (const Pairs& pairs : {Pairs{}, {.offset = 100}, {.height = 1e-3}}) {
        CHECK(percent_leaking<float>(pairs, watertight) == 0);
        CHECK(percent_leaking<double>(pairs, watertight) == 0);
    }
}

TEST_CASE("S11 rays aimed at edges leave the textbook's closed sphere, random ones do not") {
    constexpr int rays = 20'000;
    for (const double offset : {0.0, 100.0}) {
        const Globe<float> globe{1, Vector3<double>(offset)};
        Rng                rng{11, 0, 0, 0};
        int                aimed = 0, random = 0;
        for (int i = 0; i < rays; ++i) {
            aimed += textbook_hits(globe.mesh, globe.aimed(rng)) ? 0 : 1;
            random += textbook_hits(globe.mesh, globe.anywhere(rng)) ? 0 : 1;
        }
        CHECK(within_factor_3(100.0 * aimed / rays, offset == 0 ? 11.638 : 12.265));
        CHECK(random == 0);
    }
}

TEST_CASE_TEMPLATE("S11 of a million rays aimed at edges and vertices none leaves a watertight mesh", T,
                   float, double) {
    int rays = 0;
    for (const double flat : {1.0, 0.01}) {
        for (const double scale : {1.0, 1e-4, 1e4}) {
            for (const double offset : {0.0, 100.0}) {
                // A mesh of which rounding leaves nothing is closed all the same, but has no inside.
                if (flat * scale < 1e-3 && offset > 0) continue;
                const Globe<T>     globe{scale, Vector3<double>(offset), flat};
                const Hierarchy<T> hierarchy(globe.mesh);
                Rng                rng{12, 0, 0, 0};
                int                lost = 0;
                for (int i = 0; i < 100'000; ++i) lost += hierarchy.nearest(globe.aimed(rng)) ? 0 : 1;
                rays += 100'000;
                CAPTURE(flat);
                CAPTURE(scale);
                CAPTURE(offset);
                CHECK(lost == 0);
            }
        }
    }
    CHECK(rays >= 1'000'000);
}
