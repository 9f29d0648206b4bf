/// @file form_factors.cpp
/// Form factors against closed forms, and the laws that hold for all of them.

#include "radiosity/form_factors.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <span>
#include <stdexcept>
#include <tuple>
#include <vector>

#include "../../chapters/08_radiosity/factor_methods.hpp"
#include "../../chapters/08_radiosity/inside_of_a_cube.hpp"
#include "geometry/sphere.hpp"
#include "law.hpp"
#include "math/extremes.hpp"
#include "math/gauss_legendre.hpp"
#include "math/square.hpp"
#include "near.hpp"
#include "patch_shapes.hpp"
#include "radiometry/projected_solid_angle.hpp"
#include "radiosity/closed_form_factors.hpp"
#include "radiosity/closure.hpp"
#include "radiosity/cosine_rays.hpp"
#include "radiosity/exchange_area.hpp"
#include "radiosity/hemicube.hpp"
#include "radiosity/point_form_factors.hpp"
#include "radiosity/visible_share.hpp"
#include "statistics/running.hpp"

using namespace sr;
using sr::test::check_law;
using sr::test::grey;
using sr::test::level;
using sr::test::near;
using sr::test::upright;

namespace {

using Point = Vector3<double>;

constexpr double pi = std::numbers::pi;

/// The unit cube from inside, each face cut into n x n.
Patches cube(int n) {
    return cut(inside_of_a_cube(), 1.0 / n);
}

/// From z = -1e6 to 1e6 and thin as a line there, a plane's strip from p to q; the light goes to the left of that way.
/// What leaves by its ends is about 1e-12 of what its middle gets.
Patch strip(Vector2<double> p, Vector2<double> q) {
    constexpr double end = 1e6;
    return {{p.x, p.y, -end}, {p.x, p.y, end}, {q.x, q.y, end}, {q.x, q.y, -end}};
}

/// A cylinder along z, as a prism whose sides are strips: 720 of them lie as near to it as 1e-5 of its radius.
std::vector<Patch> cylinder(Vector2<double> centre, double r) {
    std::vector<Patch> sides;
    constexpr int      n     = 720;
    const auto         point = [&](int k) {
        return Vector2<double>{centre.x + r * std::cos(2 * pi * k / n),
                               centre.y + r * std::sin(2 * pi * k / n)};
    };
    for (int k = 0; k < n; ++k) sides.push_back(strip(point(k + 1), point(k)));
    return sides;
}

/// From the point p of the plane z = 0, with the normal n, to all of something convex.
double from_line(Vector2<double> p, Vector2<double> n, const std::vector<Patch>& to) {
    double sum = 0;
    for (const auto& patch : to) sum += contour_form_factor({p.x, p.y, 0}, {n.x, n.y, 0}, patch);
    return sum;
}

/// The mean over a strip from p to q; the light goes to the left of that way.
double from_strip(Vector2<double> p, Vector2<double> q, const std::vector<Patch>& to) {
    const Vector2<double> along = q - p;
    const double          size  = std::hypot(along.x, along.y);
    double                sum   = 0;
    for (const auto& [s, weight] : gauss_legendre(64, 0, 1))
        sum += weight * from_line(p + s * along, {-along.y / size, along.x / size}, to);
    return sum;
}

double exchange_of(const Patch& from, const Patch& to, double tolerance) {
    return exchange_area(from, to, tolerance) / from.area();
}

}  // namespace

TEST_CASE("C1: equal squares that face each other, in closed form") {
    for (const auto& [c, expected] :
         {std::tuple{1.0, 0.19982489569838738}, {0.1, 0.82699452239725658}, {10.0, 0.0031620568387576016}})
        CHECK(opposed_rectangles(1, 1, c) == near(expected, 1e-10));
    CHECK(opposed_rectangles(2, 3, 0.7) == near(opposed_rectangles(3, 2, 0.7), 1e-14));
    CHECK(opposed_rectangles(20, 30, 7) == near(opposed_rectangles(2, 3, 0.7), 1e-14));
    // the series meets the formula where it takes over
    CHECK(opposed_rectangles(1, 0.5, 30 * (1 + 1e-12)) ==
          near(opposed_rectangles(1, 0.5, 30 * (1 - 1e-12)), 1e-11));
}

TEST_CASE("C2, C3: rectangles at a right angle, in closed form") {
    CHECK(perpendicular_rectangles(1, 1, 1) == near(0.20004377607540315, 1e-13));
    CHECK(perpendicular_rectangles(1, 2, 3) == near(0.16169401433302758, 1e-13));
    CHECK(perpendicular_rectangles(2, 1, 0.5) == near(0.16685539497330043, 1e-13));
    CHECK(opposed_rectangles(1, 1, 1) + 4 * perpendicular_rectangles(1, 1, 1) == near(1, 1e-14));
}

TEST_CASE("C6: disks on one axis, in closed form") {
    CHECK(coaxial_disks(1, 1, 1) == near(0.38196601125010515, 1e-14));
    CHECK(coaxial_disks(1, 2, 1) == near(0.7639320225002103, 1e-14));
    CHECK(coaxial_disks(0.5, 1, 3) == near(0.097794236896834982, 1e-14));
    CHECK(coaxial_disks(1, 3, 0) == 1);
    CHECK(coaxial_disks(3, 1, 0) == near(1.0 / 9, 1e-15));
}

TEST_CASE("C1-C3: the exchange area meets the closed forms to its tolerance") {
    for (const double tolerance : {0.01, 1e-3, 1e-4, 1e-6}) {
        CAPTURE(tolerance);
        for (const double c : {0.1, 1.0, 10.0})
            CHECK(exchange_of(level_square(), level_square(c).reversed(), tolerance) ==
                  near(opposed_rectangles(1, 1, c), tolerance));
        CHECK(exchange_of(level_square(), upright_square(), tolerance) ==
              near(0.20004377607540315, tolerance));
        CHECK(exchange_of(level(2, 1), upright(1, 3), tolerance) == near(0.16169401433302758, tolerance));
        CHECK(exchange_of(level(1, 2), upright(2, 0.5), tolerance) == near(0.16685539497330043, tolerance));
    }
}

TEST_CASE("C3: of a floor that goes on behind a wall, all is seen that is before it, however little") {
    const Patch wall = upright_square();  // not smaller than the floor, which is summed up
    for (const double before : {0.01, 0.05, 0.3, 0.5, 0.95})
        for (const double tolerance : {0.01, 1e-3, 1e-4}) {
            CAPTURE(before);
            CAPTURE(tolerance);
            const Patch floor{{before - 1, 0, 0}, {before, 0, 0}, {before, 1, 0}, {before - 1, 1, 0}};
            CHECK(exchange_area(floor, wall, tolerance) ==
                  near(before * perpendicular_rectangles(1, before, 1), tolerance));
        }
}

TEST_CASE(
    "patches of the Cornell box by whose edge rules of two and three points agree, both wrong, keep the "
    "tolerance") {
    const std::pair<Patch, Patch> pairs[] = {
        {{{552.34285714285714, 235.2, 559.2},
          {552.8, 235.2, 479.31428571428575},
          {551.88571428571427, 156.8, 479.31428571428575}},
         {{550.88, 109.76, 559.2},
          {440.704, 109.76, 559.2},
          {441.728, 219.52, 559.2},
          {552.16, 219.52, 559.2}}},
        {{{555.54285714285714, 470.4, 479.31428571428575},
          {556, 548.8, 559.2},
          {556, 548.8, 479.31428571428575}},
         {{554.72, 439.04, 559.2}, {443.776, 439.04, 559.2}, {444.8, 548.8, 559.2}, {556, 548.8, 559.2}}}};
    for (const auto& [small, large] : pairs) {
        double exact = 0;  // summed up over the other one: its pieces are the smaller ones
        for (const Patch& piece : pieces_of(large, 8)) exact += exchange_area(piece, small, 1e-6);
        CHECK(exchange_area(small, large, 1e-3) == near(exact, 1e-3));
    }
}

TEST_CASE("a patch is cut along another's surface, and what touches that is not") {
    const auto area_before = [](const Patch& patch, const Patch& other) {
        double sum = 0;
        for (const auto& part : patch.parts_before(other)) {
            CHECK(dot(part.normal(), patch.normal()) == near(1, 1e-14));
            sum += part.area();
        }
        return sum;
    };
    const Patch wall = upright_square(), square = level_square(), triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    CHECK(square.parts_before(wall).size() == 1);
    CHECK(area_before(square, wall) == 1);
    CHECK(square.parts_before(wall.reversed()).empty());
    // planes through (c, 0) and (0, c) of the floor that look away from its corner: 3 to 5 corners are left
    const auto along = [](double c) { return Patch{{c, 0, 0}, {0, c, 0}, {0, c, 1}}; };
    for (const double c : {0.5, 0.25}) CHECK(area_before(square, along(c)) == near(1 - c * c / 2, 1e-14));
    CHECK(square.parts_before(along(0.5).reversed()).size() == 1);
    CHECK(area_before(square, along(0.5).reversed()) == near(0.125, 1e-14));
    CHECK(area_before(square, along(1.5).reversed()) == near(0.875, 1e-14));
    CHECK(area_before(triangle, along(0.5)) == near(0.375, 1e-14));
    CHECK(area_before(triangle, along(0.5).reversed()) == near(0.125, 1e-14));
}

TEST_CASE("what is not seen from before, or does not look here, has no exchange") {
    CHECK(exchange_area(level_square(), level_square(1)) == 0);
    CHECK(exchange_area(level_square(1), level_square().reversed()) == 0);
    CHECK(exchange_area(level_square(), level(2, 1)) == 0);
    const Patches    patches = cube(1);
    const Visibility visibility{mesh_of(patches).mesh};
    CHECK_THROWS_AS((void)form_factors(patches, visibility, {.tolerance = 0}), std::invalid_argument);
    CHECK_THROWS_AS((void)form_factors(patches, visibility, {.tolerance = std::nan("")}),
                    std::invalid_argument);
    CHECK_THROWS_AS((void)form_factors(patches, visibility, {.strata = 0}), std::invalid_argument);
}

TEST_CASE(
    "form factors of a cube's patches: rows add up to 1, reciprocity is exact, threads change nothing") {
    for (const int n : {1, 2, 4}) {
        CAPTURE(n);
        const Patches    patches = cube(n);
        const Visibility visibility{mesh_of(patches).mesh};
        const auto       F     = form_factors(patches, visibility);
        double           worst = 0, lopsided = 0;
        for (std::size_t i = 0; i < F.size(); ++i) {
            CHECK(F(i, i) == 0);
            worst = std::max(worst, std::abs(F.row_sum(i) - 1));
            for (std::size_t j = 0; j < F.size(); ++j)
                lopsided = std::max(lopsided, std::abs(patches.shapes[i].area() * F(i, j) -
                                                       patches.shapes[j].area() * F(j, i)));
        }
        CHECK(worst <= 1e-4);
        CHECK(lopsided <= 1e-16);
        const auto again = form_factors(patches, visibility, {}, {.threads = 7});
        for (std::size_t i = 0; i < F.size(); ++i) CHECK(std::ranges::equal(F.row(i), again.row(i)));
    }
}

TEST_CASE(
    "of patches of any area with others between them, reciprocity is exact, and threads change nothing") {
    auto polygons = inside_of_a_box({1, 2, 3});
    for (const auto& shape : {blocking_square(), blocking_square().reversed()})
        polygons.push_back(grey(shape));
    const Patches    patches = cut(polygons, 0.7);
    const Visibility visibility{mesh_of(patches).mesh};
    const auto       F        = form_factors(patches, visibility, {}, {.threads = 1});
    double           lopsided = 0;
    int              unequal = 0, partly_hidden = 0;
    for (std::size_t i = 0; i < F.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const Patch &p = patches.shapes[i], &q = patches.shapes[j];
            const double there = p.area() * F(i, j), back = q.area() * F(j, i), open = exchange_area(p, q);
            lopsided = max_or_nan(lopsided, std::abs(there - back) / std::max(there, 1e-300));
            if (there > 0 && p.area() > 1.1 * q.area()) ++unequal;
            if (there > 0 && there < 0.99 * open) ++partly_hidden;
        }
    CHECK(lopsided <= 4e-16);  // two roundings on either side
    CHECK(unequal > 100);
    CHECK(partly_hidden > 100);
    for (const int threads : {2, 7}) {
        const auto again = form_factors(patches, visibility, {}, {.threads = threads});
        for (std::size_t i = 0; i < F.size(); ++i) CHECK(std::ranges::equal(F.row(i), again.row(i)));
    }
}

TEST_CASE("from a point of a wall no piece of that wall is seen, however its corners are rounded") {
    for (const int n : {3, 5, 6, 7, 12}) {
        const Patches patches = cube(n);
        for (std::size_t i = 0; i < patches.size(); ++i) {
            const Patch& from = patches.shapes[i];
            double       sum  = 0;
            for (const auto& to : patches.shapes) {
                const double F = contour_form_factor(from.at({0.3, 0.7}), from.normal(), to);
                if (dot(from.normal(), to.normal()) > 0.5) CHECK(F == 0);
                sum += F;
            }
            CHECK(sum == near(1, 1e-12));
        }
    }
}

TEST_CASE("C7: disks inscribed in a sphere") {
    const auto radius = [](double h) { return std::sqrt(0.25 - h * h); };
    CHECK(coaxial_disks(radius(0.25), radius(0.15), 0.4) == near(0.46666666666666667, 1e-14));
    CHECK(coaxial_disks(radius(0.25), radius(0.15), 0.1) == near(0.86666666666666667, 1e-14));
}

TEST_CASE("C8, C10, C13: spheres, from points of what faces them") {
    // From a disk of radius 1 at the distance h: the mean over its area, 2 int s ds; by reciprocity A_disk / A_sphere
    // as much.
    const auto to_sphere = [](double aside, double h, double r) {
        return projected_solid_angle(Sphere<double>{{aside, 0, h}, r}).value() / pi;
    };
    for (const auto& [h, expected] :
         {std::pair{0.5, 0.27639320225002103}, {1.0, 0.14644660940672624}, {2.0, 0.052786404500042061}}) {
        constexpr double r   = 0.25;
        double           sum = 0;
        for (const auto& [s, weight] : gauss_legendre(40, 0, 1)) sum += weight * 2 * s * to_sphere(s, h, r);
        CHECK(sum / (4 * r * r) == near(expected, 1e-12));
    }
    CHECK(to_sphere(0, 2, 1) == near(0.25, 1e-15));
    double face = 0;
    for (const auto& [x, wx] : gauss_legendre(40, -0.5, 0.5))
        for (const auto& [y, wy] : gauss_legendre(40, -0.5, 0.5))
            face += wx * wy * to_sphere(std::hypot(x, y), 0.5, 0.5);
    CHECK(face == near(0.52359877559829887, 1e-12));  // C13
    CHECK(face / (4 * pi * 0.25) == near(0.16666666666666667, 1e-12));
}

TEST_CASE("C11, C12: on the inside of a sphere, the kernel is 1 / (4 pi R^2) between any two points") {
    check_law("the kernel is the same", [] {
        const auto point = [] {
            const auto z = *rc::gen::inRange(-999, 1000) / 1000.0, turn = *rc::gen::inRange(0, 1000) / 1000.0;
            const auto r = std::sqrt((1 - z) * (1 + z));
            return Point{r * std::cos(2 * pi * turn), r * std::sin(2 * pi * turn), z};
        };
        const Point p = point(), q = point();
        RC_PRE(length(p - q) > 1e-3);
        const double kernel = form_factor_kernel(2.0 * p, -p, 2.0 * q, -q);  // R = 2
        RC_ASSERT(std::abs(kernel * 16 * pi - 1) <= 1e-9);
    });
    // Of all that any point of a sphere sends, a hemisphere gets 1/2 and a cap of 60 degrees 1/4: rings of it, in sum.
    const auto cap = [](const Point& p, double angle) {
        double sum = 0;
        for (const auto& [z, dz] : gauss_legendre(8, std::cos(angle), 1))
            for (const auto& [turn, around] : gauss_legendre(8, 0, 2 * pi)) {
                const double r = std::sqrt(1 - z * z);
                const Point  q{r * std::cos(turn), r * std::sin(turn), z};
                sum += dz * around * form_factor_kernel(p, -p, q, -q);
            }
        return sum;
    };
    const Point p{std::sin(2.0), 0, std::cos(2.0)};
    CHECK(cap(p, pi / 2) == near(0.5, 1e-12));
    CHECK(cap(p, pi / 3) == near(0.25, 1e-12));
    CHECK(cap(Point{1, 0, 0}, pi / 2) ==
          near(0.5, 1e-12));  // C12: of the dome itself, its base gets the rest
}

TEST_CASE("C14: long rectangles are strips") {
    constexpr double length = 1e4;  // ends take a share of about 1 / length
    CHECK(opposed_rectangles(length, 1, 1) == near(0.41421356237309505, 2e-4));
    CHECK(opposed_rectangles(length, 1, 0.25) == near(0.78077640640441514, 2e-4));
    CHECK(perpendicular_rectangles(length, 1, 1) == near(0.29289321881345248, 2e-4));
    CHECK(perpendicular_rectangles(length, 1, 3) == near(0.41886116991581033, 3e-4));
    CHECK(perpendicular_rectangles(length, 1, 3) != near(0.41886116991581033, 1e-7));
}

TEST_CASE(
    "C14, C16: strips, from points on them: crossed strings, a wedge, and a prism of sides 3, 4 and 5") {
    const Vector2<double> o{0, 0}, right{1, 0}, aslant{std::cos(pi / 6), std::sin(pi / 6)};
    CHECK(from_strip(o, right, {strip({1, 1}, {0, 1})}) == near(0.41421356237309505, 1e-9));
    CHECK(from_strip(o, right, {strip({0, 3}, o)}) ==
          near(0.41886116991581033, 1e-4));  // its kernel has a kink at o
    CHECK(from_strip(o, right, {strip(aslant, o)}) == near(0.74118095489747924, 1e-4));  // 1 - sin 15 degrees

    const Vector2<double> a{4, 0}, b{0, 3};
    CHECK(from_strip(b, o, {strip(o, a)}) == near(1.0 / 3, 1e-4));
    CHECK(from_strip(b, o, {strip(a, b)}) == near(2.0 / 3, 1e-4));
    CHECK(from_strip(o, a, {strip(b, o)}) == near(0.25, 1e-4));
    CHECK(from_strip(o, a, {strip(a, b)}) == near(0.75, 1e-4));
    CHECK(from_strip(a, b, {strip(b, o)}) == near(0.4, 1e-4));
    CHECK(from_strip(a, b, {strip(o, a)}) == near(0.6, 1e-4));
}

TEST_CASE("C17, C18: long cylinders, seen from each other and from a strip") {
    const auto around = [](double gap) {  // the mean over one of radius 1, of which half can see the other
        const auto other = cylinder({2 + gap, 0}, 1);
        double     sum   = 0;
        for (const auto& [turn, weight] : gauss_legendre(64, 0, pi)) {
            const Vector2<double> n{std::cos(turn), std::sin(turn)};
            sum += weight / pi * from_line(n, n, other);
        }
        return sum;
    };
    CHECK(around(1) == near(0.11069596963167251, 1e-4));
    CHECK(around(0) == near(0.18169011381620933, 2e-3));  // they touch, and the prism doesn't quite
    CHECK(from_strip({0.25, 0}, {2, 0}, cylinder({0, 1}, 0.5)) == near(0.24633430133349324, 2e-5));
}

TEST_CASE("C20: squares as points") {
    for (const auto& [c, error] : {std::pair{1.0, 0.59294408772890194},
                                   {2.0, 0.16019753021792666},
                                   {5.0, 0.026476840920680862},
                                   {10.0, 0.0066545366365307754}})
        CHECK(point_form_factor(level_square(), level_square(c).reversed()) / opposed_rectangles(1, 1, c) -
                  1 ==
              near(error, 1e-10));
}

TEST_CASE("laws of random patches: what one sends to the other comes back, and no more than all") {
    const auto between = [](double low, double high) {
        return low + (high - low) * (*rc::gen::resize(100, rc::gen::inRange(0, 1000)) / 1000.0);
    };
    const auto triangle = [&](double low, double high) {
        const double x = between(-0.5, 0.5), y = between(-0.5, 0.5);
        const auto   corner = [&](double turn) {
            const double r = between(0.5, 1.5);
            return Point{x + r * std::cos(2 * pi * turn), y + r * std::sin(2 * pi * turn),
                         between(low, high)};
        };
        const Point a = corner(0), b = corner(1.0 / 3);
        return Patch{a, b, corner(2.0 / 3)};
    };
    const auto facing = [](const Patch& patch, const Point& there) {
        return dot(patch.normal(), there - patch.centre()) > 0 ? patch : patch.reversed();
    };
    const auto sees_all = [](const Patch& patch, const Patch& other) {
        return std::ranges::all_of(
            other.corners(), [&](const Point& p) { return dot(patch.normal(), p - patch.centre()) > 0; });
    };
    check_law(
        "reciprocity",
        [&] {
            const Patch below = triangle(0, 0.1), above = triangle(0.5, 0.6);
            const Patch first = facing(below, above.centre()), second = facing(above, below.centre());
            RC_PRE(sees_all(first, second));
            RC_PRE(sees_all(second, first));
            const double tolerance = 1e-3, there = exchange_area(first, second, tolerance);
            RC_ASSERT(there >= 0);
            RC_ASSERT(there <= std::min(first.area(), second.area()) * (1 + tolerance));
            // once the one is summed up and once the other
            double back = 0, forth = 0;
            for (const auto& [s, ws] : gauss_legendre(24, 0, 1))
                for (const auto& [t, wt] : gauss_legendre(24, 0, 1)) {
                    const double weight = ws * wt * 2 * (1 - t);  // of a triangle, the side t = 1 is a point
                    back += weight * second.area() *
                            contour_form_factor(second.at({s, t}), second.normal(), first);
                    forth +=
                        weight * first.area() * contour_form_factor(first.at({s, t}), first.normal(), second);
                }
            RC_ASSERT(std::abs(back - forth) <= 1e-6);
            RC_ASSERT(std::abs(back - there) <= tolerance * std::max(there, 1e-3) + 1e-6);
        },
        200);
}

TEST_CASE(
    "rays, half a cube and random pairs meet the closed forms of a cube; the hemicube the better the more "
    "pixels") {
    const Patches    patches = cube(1);
    const Visibility open{mesh_of(patches).mesh};
    const double     opposed = 0.19982489569838738, beside = 0.20004377607540315;
    Running          rays, beside_rays, pairs;
    const CosineRays sent(patches);
    for (int repeat = 0; repeat < 64; ++repeat) {
        Rng        rng{1, repeat, 0, 0};
        const auto row = sent.row(0, 16, rng);
        CHECK(std::accumulate(row.begin(), row.end(), 0.0) == near(1, 1e-12));
        rays.add(row[1]);
        beside_rays.add(row[2]);
        pairs.add(sampled_form_factor(patches.shapes[0], patches.shapes[1], open, 16, rng));
    }
    CHECK(std::abs(rays.mean() - opposed) <= 5 * rays.standard_error());
    CHECK(std::abs(beside_rays.mean() - beside) <= 5 * beside_rays.standard_error());
    CHECK(std::abs(pairs.mean() - opposed) <= 5 * pairs.standard_error());
    CHECK(8 * rays.standard_error() <= std::sqrt(opposed * (1 - opposed)) / 16);  // of one row, by 16^2 rays
    CHECK(8 * beside_rays.standard_error() <= std::sqrt(beside * (1 - beside)) / 16);
    CHECK(std::abs(pairs.mean() - 1.02 * opposed) > 5 * pairs.standard_error());  // they could tell
    // From the middle of a face: a square of side 1 at the distance 1 fills 0.2394... of its base, by the contour.
    const double from_middle =
        contour_form_factor(patches.shapes[0].centre(), patches.shapes[0].normal(), patches.shapes[1]);
    CHECK(from_middle == near(0.75226 / pi, 1e-4));  // B8, chapter 5: a unit square at the height 1
    for (const auto& [resolution, error] : {std::pair{16, 0.03}, {64, 0.01}, {256, 2e-3}}) {
        const auto row = Hemicube(patches, resolution).row(0);
        CHECK(std::accumulate(row.begin(), row.end(), 0.0) == near(1, 1e-12));
        CHECK(row[0] == 0);
        CHECK(row[1] == near(from_middle, error));
        for (std::size_t j = 2; j < 6; ++j) CHECK(row[j] == near((1 - from_middle) / 4, error));
    }
    CHECK_THROWS_AS((void)Hemicube(patches, 5), std::invalid_argument);
    CHECK_THROWS_AS((void)Hemicube(patches, 0), std::invalid_argument);
}

TEST_CASE("in a low room, where a hemicube's sides see the ceiling too, each face is as the contour says") {
    const Patches  patches = cut(inside_of_a_box({1, 0.8, 0.25}), 1);
    const Hemicube hemicube(patches, 256);
    for (std::size_t i = 0; i < 6; ++i) {
        const Patch& from = patches.shapes[i];
        const auto   row  = hemicube.row(i);
        for (std::size_t j = 0; j < 6; ++j) {
            if (j == i) continue;
            CAPTURE(i);
            CAPTURE(j);
            CHECK(row[j] == near(contour_form_factor(from.centre(), from.normal(), patches.shapes[j]), 0.01));
        }
    }
}

TEST_CASE("rays and pixels that meet a patch from behind are lost") {
    const Patches patches = cut(std::vector{grey(level_square()), grey(level_square(1))}, 1);  // both look up
    Rng           rng{5, 0, 0, 0};
    for (const auto& row : {CosineRays(patches).row(0, 16, rng), Hemicube(patches, 16).row(0)}) {
        CHECK(row[0] == 0);
        CHECK(row[1] == 0);
    }
}

TEST_CASE("what hides a part of a square from another hides as much of the form factor") {
    const Patch   first = level_square(), second = level_square(1).reversed();
    const Patch   between = blocking_square();
    const Patches patches =
        cut(std::vector{grey(first), grey(second), grey(between), grey(between.reversed())}, 1);
    const Visibility visibility{mesh_of(patches).mesh};
    // lines with the slopes (u, v) that pass [0, 1]^2, the blocker's middle half, and [0, 1]^2, on a fine grid
    const auto       blocked = [](double u) {
        return std::max(0.0, std::min({1.0, 1 - u, 0.75 - u / 2}) - std::max({0.0, -u, 0.25 - u / 2}));
    };
    double seen = 0;
    for (const double split : {0.0, 0.5})
        for (const double other : {0.0, 0.5})
            for (const auto& [u, wu] : gauss_legendre(24, split, split + 0.5))
                for (const auto& [v, wv] : gauss_legendre(24, other, other + 0.5))
                    seen += 4 * wu * wv * ((1 - u) * (1 - v) - blocked(u) * blocked(v)) /
                            (pi * square(1 + u * u + v * v));
    CHECK(seen == near(0.099506294598984786, 1e-12));
    Running pairs, share;
    for (int repeat = 0; repeat < 64; ++repeat) {
        Rng rng{2, repeat, 0, 0};
        pairs.add(sampled_form_factor(first, second, visibility, 16, rng));
        share.add(opposed_rectangles(1, 1, 1) * visible_share(first, second, visibility, 16, rng));
    }
    CHECK(std::abs(pairs.mean() - seen) <= 5 * pairs.standard_error());
    CHECK(std::abs(share.mean() - seen) <= 5 * share.standard_error());
    CHECK(share.standard_error() < pairs.standard_error());
    CHECK(8 * share.standard_error() <=
          opposed_rectangles(1, 1, 1) / (2 * 16));  // of one, by 16^2 rays; v is 1/2
    Rng rng{3, 0, 0, 0};
    CHECK(visible_share(second, between, visibility, 4, rng) == 1);
    CHECK(visible_share(first, between.reversed(), visibility, 4, rng) == 1);
}

TEST_CASE("what a point's own horizon cuts off is not hidden, and what is hidden counts as it would shine") {
    const Vector3<double> n{1, 0, 0};
    const Patch           wall{{0, -1, 0}, {0, 1, 0}, {0, 1, 0.8}, {0, -1, 0.8}};
    const Patch           lamp{{-1, -0.5, 1}, {-1, 0.5, 1}, {1, 0.5, 1}, {1, -0.5, 1}};
    const auto            from = wall.surface_point({0, 0, 0.5});
    const auto roof = [](double from_x, double to_x) {  // halfway up to the lamp, over the y of all rays
        return Visibility{
            Mesh<double>{{{from_x, -2, 0.75}, {to_x, -2, 0.75}, {to_x, 2, 0.75}, {from_x, 2, 0.75}},
                         {{0, 1, 2}, {0, 2, 3}}}};
    };
    Rng rng{12, 0, 0, 0};
    CHECK(visible_share(from, lamp, roof(-2, 0), 8, rng) == 1);  // below what is behind the wall
    CHECK(visible_share(from, lamp, roof(-2, 1), 8, rng) == 0);

    // A roof over 0 < x < 1/4 hides the lamp's 0 < x < 1/2.
    const Patch  rest{{0.5, -0.5, 1}, {0.5, 0.5, 1}, {1, 0.5, 1}, {1, -0.5, 1}};
    const double expected =
        contour_form_factor(from.position, n, rest) / contour_form_factor(from.position, n, lamp);
    Running share;
    for (int repeat = 0; repeat < 64; ++repeat) share.add(visible_share(from, lamp, roof(-2, 0.25), 16, rng));
    CHECK(std::abs(share.mean() - expected) <= 5 * share.standard_error());
    CHECK(share.standard_error() <= 2e-3);
    CHECK(std::abs(0.5 - expected) > 0.05);  // of the area that is before the wall, half is hidden
}

TEST_CASE("C15: long strips with a strip between them") {
    constexpr double half  = 100;  // of their length: what leaves by the ends is about 2 / 200 of the light
    const auto       strip = [](double width, double z) {
        return Patch{{-width, -half, z}, {width, -half, z}, {width, half, z}, {-width, half, z}};
    };
    const Patch      first = strip(1, 0), second = strip(1, 2).reversed(), between = strip(0.5, 1);
    const Patches    patches = cut(std::vector{grey(first), grey(second), grey(between)}, 200);
    const Visibility visibility{mesh_of(patches).mesh};
    const double     open = exchange_area(first, second, 1e-5) / first.area();
    CHECK(open == near(0.41421356237309505, 0.01));
    Running seen;
    for (int repeat = 0; repeat < 64; ++repeat) {
        Rng rng{4, repeat, 0, 0};
        seen.add(open * visible_share(first, second, visibility, 32, rng));
    }
    CHECK(std::abs(seen.mean() - 0.11803398874989485) <= 5 * seen.standard_error() + 0.01 * 0.118);
    CHECK(seen.standard_error() < 0.01);
}

TEST_CASE("scaling keeps reciprocity and makes rows add up to 1; normalising them does only the latter") {
    const Patches    patches = cube(2);
    const Visibility open{mesh_of(patches).mesh};
    FormFactorMatrix F = form_factors(patches, open);
    for (std::size_t i = 0; i < F.size(); ++i)  // off by some per cent, and still reciprocal: areas are equal
        for (std::size_t j = 0; j < F.size(); ++j) F(i, j) *= 1 + 0.05 * std::sin(double(i * j + i + j));
    const auto lopsided = [](const FormFactorMatrix& of) {
        double worst = 0;
        for (std::size_t i = 0; i < of.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) worst = std::max(worst, std::abs(of(i, j) - of(j, i)));
        return worst;
    };
    CHECK(lopsided(F) == 0);
    CHECK(closure_defect(F) > 0.005);
    CHECK(closure_defect(symmetrically_scaled(F)) <= 1e-12);
    CHECK(lopsided(symmetrically_scaled(F)) <= 1e-16);
    CHECK(closure_defect(with_normalised_rows(F)) <= 1e-15);
    CHECK(lopsided(with_normalised_rows(F)) > 1e-5);

    FormFactorMatrix blind(2);
    CHECK_THROWS_WITH_AS((void)symmetrically_scaled(blind), doctest::Contains("patch 0 sees nothing"),
                         std::invalid_argument);
    CHECK_THROWS_WITH_AS((void)with_normalised_rows(blind), doctest::Contains("patch 0 sees nothing"),
                         std::invalid_argument);
    FormFactorMatrix star(3);  // two patches that see only the third, which has no room for both
    star(0, 2) = star(2, 0) = star(1, 2) = star(2, 1) = 0.5;
    CHECK_THROWS_WITH_AS((void)symmetrically_scaled(star), doctest::Contains("is the scene closed"),
                         std::runtime_error);
    blind(0, 1) = std::nan("");
    blind(1, 0) = 1;
    CHECK_THROWS_AS((void)symmetrically_scaled(blind), std::invalid_argument);
    CHECK_THROWS_AS((void)with_normalised_rows(blind), std::invalid_argument);
    CHECK(std::isnan(closure_defect(blind)));
    for (const double sum : {0.75, 1.25}) {
        blind(0, 1) = sum;
        CHECK(closure_defect(blind) == 0.25);
    }
    blind(0, 1) = blind(1, 0) = HUGE_VAL;
    CHECK_THROWS_AS((void)symmetrically_scaled(blind), std::runtime_error);
}

TEST_CASE("from middle to middle the second area counts, as points or as a disk; and nothing from behind") {
    const Patch from = level_square(), to = level(2, 1, 3).reversed();  // their middles are (1/2, 0, 3) apart
    CHECK(point_form_factor(from, to) == near(2 * 9 / (pi * square(9.25)), 1e-14));
    CHECK(disk_form_factor(from, to) == near(9 / 9.25 * 2 / (pi * 9.25 + 2), 1e-14));
    for (const auto& method : {point_form_factor, disk_form_factor}) {
        CHECK(method(from, to.reversed()) == 0);
        CHECK(method(from.reversed(), to) == 0);
        CHECK(method(from.reversed(), to.reversed()) == 0);
    }
}

TEST_CASE("patches face each other if each lies before the other's surface; pieces of a wall do not") {
    const Patch floor = level_square(), above = level_square(1);
    CHECK(face_each_other(floor, above.reversed()));
    CHECK(face_each_other(floor, upright_square()));
    CHECK(!face_each_other(floor, above));
    CHECK(!face_each_other(above, floor));
    CHECK(!face_each_other(floor.reversed(), above));
    const auto pieces = pieces_of(Patch{{1, 0, 0.1}, {0, 1, 0.3}, {0.1, 0.2, 1}}, 8);
    for (const auto& a : pieces)
        for (const auto& b : pieces) CHECK(!face_each_other(a, b));
}

TEST_CASE("random pairs count each quarter of a patch, and the whole of it, by its area") {
    const Patch      from = level_square(), to = Patch{{0, 0, 1}, {3, 0, 1}, {1, 1, 1}, {0, 1, 1}}.reversed();
    const Visibility open{Mesh<double>{}};
    const double     all = exchange_area(from, to, 1e-6);
    std::array<Running, 4> shares;
    Running                whole;
    for (int repeat = 0; repeat < 64; ++repeat) {
        Rng        rng{6, repeat, 0, 0};
        const auto seen = visible_quarters(from, to, open, 16, rng);
        for (std::size_t k = 0; k < 4; ++k) shares[k].add(seen[k]);
        whole.add(sampled_form_factor(from, to, open, 16, rng));
    }
    for (std::size_t k = 0; k < 4; ++k) {
        const double expected = exchange_area(from, to.quarters()[k], 1e-6) / all;
        CHECK(std::abs(shares[k].mean() - expected) <= 5 * shares[k].standard_error());
        CHECK(shares[k].standard_error() <= 2e-3);  // without areas they are off by 0.027 to 0.1
    }
    CHECK(std::abs(whole.mean() - all) <= 5 * whole.standard_error());  // the first one's area is 1
    CHECK(whole.standard_error() <= 0.01 * all);
}
