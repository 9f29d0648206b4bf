#pragma once
/// @file mirror.hpp

#include <concepts>
#include <optional>

#include "material/bsdf.hpp"
#include "material/reflect.hpp"

namespace sr {

/// A perfect mirror, f = delta(wi - r) / cos(theta), written nowhere: the cosine of the reflectance equation
/// cancels it, and what arrives from r leaves again. (Evaluated, 0 / 0 lies in wait at the horizon.)
template <std::floating_point T>
struct Mirror {
    [[nodiscard]] std::optional<BsdfSample<T>> sample(const Vector3<T>& wo, Vector2<T>, TransportMode) const {
        if (!(wo.z > 0)) return std::nullopt;
        return BsdfSample<T>{.wi = reflect(wo), .weight = 1, .pdf = {}, .is_delta = true};
    }
};

}  // namespace sr
