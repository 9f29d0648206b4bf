/// @file exchange_area.cpp

#include "radiosity/exchange_area.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <tuple>
#include <vector>

#include "math/gauss_legendre.hpp"
#include "math/square.hpp"
#include "radiosity/point_form_factors.hpp"

namespace sr {
namespace {

/// The part of the exchange that the point (s, t) of `from` stands for, where it stands for all of it.
double from_point(const Patch& from, const Patch& to, Vector2<double> st) {
    const auto  p = from.corners();
    const auto &a = p[0], &b = p[1], &c = p[2], &d = p.back();
    const auto  along = (1 - st.y) * (b - a) + st.y * (c - d), across = (1 - st.x) * (d - a) + st.x * (c - b);
    const double area = dot(from.normal(), cross(along, across));  // per ds dt
    return area * contour_form_factor(from.at(st), from.normal(), to);
}

// Rules over [0, 1], of which products in s and in t are taken.
constexpr double off_2 = 0.5 / std::numbers::sqrt3, off_3 = 0.38729833462074169;  // sqrt(3/5) / 2
constexpr std::array<QuadraturePoint, 2> two_points{{{0.5 - off_2, 0.5}, {0.5 + off_2, 0.5}}};
constexpr std::array<QuadraturePoint, 3> three_points{
    {{0.5 - off_3, 5.0 / 18}, {0.5, 4.0 / 9}, {0.5 + off_3, 5.0 / 18}}};

double by_two_points(const Patch& from, const Patch& to) {
    double sum = 0;
    for (const auto& s : two_points)
        for (const auto& t : two_points) sum += s.weight * t.weight * from_point(from, to, {s.x, t.x});
    return sum;
}

/// By three_points, and by the middle one of the nine alone.
struct Sums {
    double by_three = 0, by_one = 0;
};

Sums sums(const Patch& from, const Patch& to) {
    Sums result;
    for (const auto& s : three_points)
        for (const auto& t : three_points) {
            const double part = from_point(from, to, {s.x, t.x});
            result.by_three += s.weight * t.weight * part;
            if (s.x == 0.5 && t.x == 0.5) result.by_one = part;
        }
    return result;
}

/// Or a thousandth of the patch, if that is more: no pains are taken over less.
double at_least(double exchange, const Patch& from) {
    return std::max(exchange, 1e-3 * from.area());
}

/// `fine` is what three_points say. Two points may agree with that by chance, and both be wrong; one point, whose
/// error is about the root of theirs, hardly does at the same time. Half of what is allowed costs a hundredth more,
/// and of five pairs in 170 000 of the Cornell box that missed their tolerance it leaves one.
double refined(const Patch& from, const Patch& to, const Sums& sum_of, double allowed, int quarterings) {
    const double fine   = sum_of.by_three;
    const double by_two = std::abs(fine - by_two_points(from, to));
    const double by_one = std::abs(fine - sum_of.by_one);
    if (quarterings == 0 || (2 * by_two <= allowed && square(by_one) <= allowed * at_least(fine, from)))
        return fine;
    double sum = 0;
    for (const auto& quarter : from.quarters())
        if (quarter.area() > 0)  // of a sliver, corners may round to a line
            sum += refined(quarter, to, sums(quarter, to), allowed / 2, quarterings - 1);
    return sum;
}

}  // namespace

double exchange_area(const Patch& a, const Patch& b, double tolerance) {
    if (!face_each_other(a, b)) return 0;
    constexpr int most_quarterings = 8;
    const auto& [from, to]         = a.area() <= b.area() ? std::tie(a, b) : std::tie(b, a);
    // From behind `to` nothing is seen of it. Where its surface cuts `from`, what is summed up has a kink, and jumps
    // from 1/2 to 0 where they touch there: a whole strip in the light may lie between all points of all rules.
    const auto        parts = from.parts_before(to);
    std::vector<Sums> of_parts;
    double            fine = 0;
    for (const auto& part : parts) fine += of_parts.emplace_back(sums(part, to)).by_three;
    const double allowed = tolerance * at_least(fine, from);
    double       sum     = 0;
    for (std::size_t k = 0; k < parts.size(); ++k)
        sum += refined(parts[k], to, of_parts[k], allowed, most_quarterings);
    return sum;
}

}  // namespace sr
