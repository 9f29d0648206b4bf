/// @file patch.cpp

#include "radiosity/patch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "math/frame.hpp"
#include "radiometry/horizon.hpp"
#include "sampling/linear.hpp"

namespace sr {
namespace {

void require(bool good, const Patch& patch, const char* what) {
    if (good) return;
    std::string corners;
    for (const auto& p : patch.corners()) corners += fmt::format(" ({}, {}, {})", p.x, p.y, p.z);
    throw std::invalid_argument(fmt::format("the patch with the corners{} {}", corners, what));
}

void require_area(const Patch& patch) {
    require(patch.area() > 0 && patch.area() <= std::numeric_limits<double>::max(), patch,
            "has no area; its corners must not lie on one line");
}

}  // namespace

bool make_a_quadrilateral(const std::array<Patch::Point, 4>& corners) {
    const auto& [a, b, c, d]     = corners;
    const Vector3<double> normal = normalize(cross(c - a, d - b));
    const double          size   = std::max(length(c - a), length(d - b));
    const double     rounding    = rounding_bound(std::max({size_of(a), size_of(b), size_of(c), size_of(d)}));
    constexpr double flat        = 1e-6;  // part of its size: files are rounded to six digits
    // Both diagonals are at right angles to the normal: half as far as one corner is from the plane of the others.
    if (!(2 * std::abs(dot(normal, b - a)) <= flat * size + rounding)) return false;
    for (std::size_t i = 0; i < 4; ++i) {
        const auto before = corners[(i + 3) % 4] - corners[i], after = corners[(i + 1) % 4] - corners[i];
        if (!(dot(normal, cross(after, before)) >= -rounding * size)) return false;
    }
    return true;
}

Patch::Patch(const Point& a, const Point& b, const Point& c) : Patch({a, b, c, c}, 3) {
    require_area(*this);
}

Patch::Patch(const Point& a, const Point& b, const Point& c, const Point& d) : Patch({a, b, c, d}, 4) {
    require_area(*this);
    require(make_a_quadrilateral(corners_), *this, "is no flat convex quadrilateral; make it two triangles");
}

Patch::Patch(const std::array<Point, 4>& corners, std::size_t count) : corners_(corners), count_(count) {
    const auto& [a, b, c, d]      = corners_;
    const Vector3<double> twice_1 = cross(b - a, c - a), twice_2 = cross(c - a, d - a);
    const double          first = length(twice_1), second = length(twice_2);
    area_   = (first + second) / 2;
    normal_ = normalize(twice_1 + twice_2);
    centre_ = (first * (a + b + c) + second * (a + c + d)) / (3 * (first + second));
    error_  = rounding_bound(std::max({size_of(a), size_of(b), size_of(c), size_of(d)}));
    for (std::size_t i = 0; i < 4; ++i)
        stretch_[i] =
            dot(normal_, cross(corners_[(i + 1) % 4] - corners_[i], corners_[(i + 3) % 4] - corners_[i]));
}

double Patch::longest_side() const {
    double longest = 0;
    for (std::size_t i = 0; i < count_; ++i)
        longest = std::max(longest, length(corners_[(i + 1) % count_] - corners_[i]));
    return longest;
}

Patch::Point Patch::at(Vector2<double> st) const {
    const auto& [a, b, c, d] = corners_;
    const auto [s, t]        = std::array{st.x, st.y};
    return (1 - t) * ((1 - s) * a + s * b) + t * ((1 - s) * d + s * c);
}

Patch::Point Patch::sample(Vector2<double> u) const {
    const auto& [a, b, c, d] = stretch_;  // of a plane quadrilateral it is linear in s and in t
    const double s           = sample_linear(u.x, a + d, b + c);
    const double t           = sample_linear(u.y, (1 - s) * a + s * b, (1 - s) * d + s * c);
    return at({s, t});
}

std::array<Patch, 4> Patch::quarters() const {
    const auto& [a, b, c, d] = corners_;
    const Point ab = (a + b) / 2.0, bc = (b + c) / 2.0;
    if (count_ == 3) {
        const Point ca = (c + a) / 2.0;
        return {Patch({a, ab, ca, ca}, 3), Patch({ab, b, bc, bc}, 3), Patch({ca, bc, c, c}, 3),
                Patch({bc, ca, ab, ab}, 3)};
    }
    const Point cd = (c + d) / 2.0, da = (d + a) / 2.0, middle = (ab + cd) / 2.0;
    return {Patch({a, ab, middle, da}, 4), Patch({ab, b, bc, middle}, 4), Patch({middle, bc, c, cd}, 4),
            Patch({da, middle, cd, d}, 4)};
}

std::vector<Patch> Patch::parts_before(const Patch& other) const {
    const auto           frame = frame_around(other.normal_);  // in which the other's surface is z = 0
    std::array<Point, 4> local;
    bool                 is_cut = false;
    for (std::size_t i = 0; i < count_; ++i) {
        local[i] = frame.to_local(corners_[i] - other.centre_);
        if (std::abs(local[i].z) <= error_ + other.error_) local[i].z = 0;
        if (local[i].z < 0) is_cut = true;
    }
    if (!is_cut) return {*this};
    std::vector<Point> p;
    corners_above_horizon(std::span<const Point>(local.data(), count_),
                          [&](const Point& corner) { p.push_back(other.centre_ + frame.to_world(corner)); });
    std::vector<Patch> parts;
    const auto         add = [&](const Patch& part) {
        if (part.area_ > 0) parts.push_back(part);
    };
    if (p.size() == 3) add({{p[0], p[1], p[2], p[2]}, 3});
    if (p.size() >= 4) add({{p[0], p[1], p[2], p[3]}, 4});
    if (p.size() == 5) add({{p[0], p[3], p[4], p[4]}, 3});
    return parts;
}

Patch Patch::reversed() const {
    const auto& [a, b, c, d] = corners_;
    return count_ == 3 ? Patch({c, b, a, a}, 3) : Patch({d, c, b, a}, 4);
}

}  // namespace sr
