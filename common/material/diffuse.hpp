#pragma once
/// @file diffuse.hpp

#include <concepts>
#include <numbers>
#include <optional>

#include "material/bsdf.hpp"
#include "sampling/hemisphere.hpp"

namespace sr {

/// Lambert's surface: the same radiance into all directions, f = 1 / pi, whose albedo is 1.
template <std::floating_point T>
struct Diffuse {
    [[nodiscard]] T f(const Vector3<T>& wo, const Vector3<T>& wi) const {
        return wo.z > 0 && wi.z > 0 ? std::numbers::inv_pi_v<T> : T{0};
    }

    [[nodiscard]] Pdf<measure::SolidAngle> pdf(const Vector3<T>& wo, const Vector3<T>& wi) const {
        return wo.z > 0 ? pdf_cosine_hemisphere(wi) : Pdf<measure::SolidAngle>{};
    }

    /// Draws by the cosine: f cos / pdf is 1, whatever is drawn.
    [[nodiscard]] std::optional<BsdfSample<T>> sample(const Vector3<T>& wo, Vector2<T> u,
                                                      TransportMode) const {
        if (!(wo.z > 0)) return std::nullopt;
        const Vector3<T> wi = sample_cosine_hemisphere(u);
        return BsdfSample<T>{wi, 1, pdf(wo, wi)};
    }
};

}  // namespace sr
