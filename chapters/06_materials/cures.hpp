#pragma once
/// @file cures.hpp
/// Phong's lobe with a cosine divided out, so that it does not darken at grazing incidence: two ways.

#include <algorithm>
#include <concepts>

#include "material/phong.hpp"

namespace sr {

/// (e + 1) / 2 pi cos^e / cos(theta_i): the cosine of the reflectance equation cancels, and so does reciprocity.
template <std::floating_point T>
struct DividedByCosine {
    Phong<T> lobe;  ///< with PhongScale::density

    [[nodiscard]] T f(const Vector3<T>& wo, const Vector3<T>& wi) const {
        return wi.z > 0 ? lobe.f(wo, wi) / wi.z : T{0};
    }
};

/// (e + 2) / 2 pi cos^e / max(cos(theta_i), cos(theta_o)), reciprocal again.
/// @see Neumann, Neumann and Szirmay-Kalos, Compact Metallic Reflectance Models (1999)
template <std::floating_point T>
struct DividedByLarger {
    Phong<T> lobe;  ///< with PhongScale::albedo

    [[nodiscard]] T f(const Vector3<T>& wo, const Vector3<T>& wi) const {
        const T larger = std::max(wo.z, wi.z);
        return larger > 0 ? lobe.f(wo, wi) / larger : T{0};
    }
};

}  // namespace sr
