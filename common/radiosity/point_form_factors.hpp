#pragma once
/// @file point_form_factors.hpp
/// Form factors from one point: what a patch is replaced by where it is small, and what others are summed up of.

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

#include "math/frame.hpp"
#include "math/square.hpp"
#include "radiometry/projected_solid_angle.hpp"
#include "radiosity/patch.hpp"

namespace sr {

/// cos(theta) cos(theta') / (pi r^2) of two points and the unit normals there: the form factor per area
/// [1/length unit^2], equation (8.5) without its visibility. 0 where one is behind the other's surface.
[[nodiscard]] inline double form_factor_kernel(const Vector3<double>& p, const Vector3<double>& normal_p,
                                               const Vector3<double>& q, const Vector3<double>& normal_q) {
    const Vector3<double> d    = q - p;
    const double          at_p = dot(d, normal_p), at_q = -dot(d, normal_q);
    return at_p > 0 && at_q > 0 ? at_p * at_q / (std::numbers::pi * square(dot(d, d))) : 0;
}

/// From patch to patch as if each were its centre [1], equation (8.9). Unbounded as they come near.
[[nodiscard]] inline double point_form_factor(const Patch& from, const Patch& to) {
    return to.area() * form_factor_kernel(from.centre(), from.normal(), to.centre(), to.normal());
}

/// The same with the second as a disk of its area, which from its axis is seen as A / (pi r^2 + A), equation (8.10):
/// below 1, however near.
/// @see Wallace, Elmquist and Haines, A Ray Tracing Algorithm for Progressive Radiosity, Comp. Graphics 23(3), 1989
[[nodiscard]] inline double disk_form_factor(const Patch& from, const Patch& to) {
    const Vector3<double> d    = to.centre() - from.centre();
    const double          r2   = dot(d, d);
    const double          at_p = dot(d, from.normal()), at_q = -dot(d, to.normal());
    return at_p > 0 && at_q > 0 ? at_p / r2 * at_q * to.area() / (std::numbers::pi * r2 + to.area()) : 0;
}

/// From the point p of a surface to a whole patch [1], exact unless something is between them: the patch's projected
/// solid angle over pi, by Lambert's sum over its sides, equations (5.19) and (8.11). 0 from behind the patch, and from
/// its own plane, in which a point lies up to rounding: there the sum may jump to 1/2.
[[nodiscard]] inline double contour_form_factor(const Vector3<double>& p, const Vector3<double>& normal,
                                                const Patch& to) {
    const double rounding = rounding_bound(size_of(p)) + to.surface_point(to.centre()).error;
    if (!(dot(p - to.centre(), to.normal()) > rounding)) return 0;
    const auto                     frame   = frame_around(normal);
    const auto                     corners = to.corners();
    std::array<Vector3<double>, 4> seen;
    for (std::size_t i = 0; i < corners.size(); ++i) seen[i] = frame.to_local(corners[i] - p);
    return projected_solid_angle(std::span<const Vector3<double>>(seen.data(), corners.size())).value() /
           std::numbers::pi;
}

/// Whether some part of each lies before the other's surface, by more than their corners may be rounded: pieces of one
/// wall don't face each other. (Whether anything is between them is another question.)
[[nodiscard]] inline bool face_each_other(const Patch& a, const Patch& b) {
    const auto is_before = [](const Patch& of, const Patch& patch) {
        const double rounding =
            of.surface_point(of.centre()).error + patch.surface_point(patch.centre()).error;
        for (const auto& corner : patch.corners())
            if (dot(corner - of.centre(), of.normal()) > rounding) return true;
        return false;
    };
    return is_before(a, b) && is_before(b, a);
}

}  // namespace sr
