/// @file exchange_area.cpp

#include "radiosity/exchange_area.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
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

/// By the product of a rule in s and in t over [0, 1].
template <std::size_t n>
double by_rule(const Patch& from, const Patch& to, const std::array<QuadraturePoint, n>& rule) {
    double sum = 0;
    for (const auto& s : rule)
        for (const auto& t : rule) sum += s.weight * t.weight * from_point(from, to, {s.x, t.x});
    return sum;
}

constexpr double off_2 = 0.5 / std::numbers::sqrt3, off_3 = 0.38729833462074169;  // sqrt(3/5) / 2
constexpr std::array<QuadraturePoint, 2> two_points{{{0.5 - off_2, 0.5}, {0.5 + off_2, 0.5}}};
constexpr std::array<QuadraturePoint, 3> three_points{
    {{0.5 - off_3, 5.0 / 18}, {0.5, 4.0 / 9}, {0.5 + off_3, 5.0 / 18}}};

/// Or a thousandth of the patch, if that is more: no pains are taken over less.
double at_least(double exchange, const Patch& from) {
    return std::max(exchange, 1e-3 * from.area());
}

/// `fine` is what three_points say. Two points may agree with that by chance, and both be wrong; one point, whose
/// error is about the root of theirs, hardly does at the same time. Half of what is allowed costs a hundredth more,
/// and of five pairs in 170 000 of the Cornell box that missed their tolerance it leaves one.
double refined(const Patch& from, const Patch& to, double fine, double allowed, int quarterings) {
    const double by_two = std::abs(fine - by_rule(from, to, two_points));
    const double by_one = std::abs(fine - from_point(from, to, {0.5, 0.5}));
    if (quarterings == 0 || (2 * by_two <= allowed && square(by_one) <= allowed * at_least(fine, from)))
        return fine;
    double sum = 0;
    for (const auto& quarter : from.quarters())
        if (quarter.area() > 0)  // of a sliver, corners may round to a line
            sum += refined(quarter, to, by_rule(quarter, to, three_points), allowed / 2, quarterings - 1);
    return sum;
}

}  // namespace

double exchange_area(const Patch& a, const Patch& b, double tolerance) {
    if (!face_each_other(a, b)) return 0;
    constexpr int most_quarterings = 8;
    const auto& [from, to]         = a.area() <= b.area() ? std::tie(a, b) : std::tie(b, a);
    // From behind `to` nothing is seen of it. Where its surface cuts `from`, what is summed up has a kink, and jumps
    // from 1/2 to 0 where they touch there: a whole strip in the light may lie between all points of all rules.
    const auto          parts = from.parts_before(to);
    std::vector<double> fine;
    for (const auto& part : parts) fine.push_back(by_rule(part, to, three_points));
    const double allowed = tolerance * at_least(std::accumulate(fine.begin(), fine.end(), 0.0), from);
    double       sum     = 0;
    for (std::size_t k = 0; k < parts.size(); ++k)
        sum += refined(parts[k], to, fine[k], allowed, most_quarterings);
    return sum;
}

}  // namespace sr
