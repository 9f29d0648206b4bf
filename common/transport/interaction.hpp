#pragma once
/// @file interaction.hpp
/// Where a ray meets a surface, as BSDFs see it: in a frame whose z axis is the normal.
///
///     const Interaction<float> at(hit->point, ray.direction, Sides::two);
///     const auto sample = bsdf.sample(at.wo(), u, TransportMode::radiance);
///     trace(at.leave(sample->wi));

#include <concepts>
#include <optional>

#include "geometry/offset.hpp"
#include "geometry/ray.hpp"
#include "material/reflect.hpp"
#include "math/frame.hpp"
#include "math/vector.hpp"

namespace sr {

/// Whether a surface tells its sides apart. Glass has an inside, below its normal; of what is opaque, the side that
/// is seen is above.
enum class Sides { alike, two };

template <std::floating_point T>
class Interaction {
public:
    /// @param direction  of the ray that arrives, of any length
    Interaction(const SurfacePoint<T>& point, const Vector3<T>& direction, Sides sides) : point_{point} {
        if (sides == Sides::alike && dot(point.normal, direction) > 0) point_.normal = -point.normal;
        frame_ = frame_around(point_.normal);
        wo_    = frame_.to_local(-normalize(direction));
    }

    [[nodiscard]] const SurfacePoint<T>& point() const { return point_; }

    /// The unit vector back along the ray, in the frame.
    [[nodiscard]] const Vector3<T>& wo() const { return wo_; }

    /// A direction of space in the frame.
    [[nodiscard]] Vector3<T> to_local(const Vector3<T>& world) const { return frame_.to_local(world); }

    /// The ray that goes on from here. It starts on the side that wi says, whatever rounding makes of it in space,
    /// and its direction is a unit vector to rounding: errors don't add up from one surface to the next.
    /// @param wi  unit vector in the frame
    [[nodiscard]] Ray<T> leave(const Vector3<T>& wi) const {
        const Vector3<T> side = wi.z < 0 ? -point_.normal : point_.normal;
        return {off_surface(point_, side), normalize(frame_.to_world(wi))};
    }

private:
    SurfacePoint<T> point_;
    Frame<T>        frame_;
    Vector3<T>      wo_;
};

/// The ray's mirror image, which leaves the surface where the ray meets it.
template <std::floating_point T>
[[nodiscard]] Ray<T> reflected(const Ray<T>& ray, const SurfacePoint<T>& point) {
    const Interaction<T> at(point, ray.direction, Sides::alike);
    return at.leave(reflect(at.wo()));
}

/// The ray as it goes on behind a surface between vacuum, where the normal points, and a medium; none if it is
/// reflected totally.
/// @param n  the medium's index of refraction, > 0
template <std::floating_point T>
[[nodiscard]] std::optional<Ray<T>> refracted(const Ray<T>& ray, const SurfacePoint<T>& point, T n) {
    const Interaction<T> at(point, ray.direction, Sides::two);
    const auto           wi = refract(at.wo(), at.wo().z > 0 ? n : 1 / n);
    if (!wi) return std::nullopt;
    return at.leave(*wi);
}

}  // namespace sr
