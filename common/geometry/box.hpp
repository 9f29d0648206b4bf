#pragma once
/// @file box.hpp
/// Axis-aligned boxes, and the interval of a ray inside one.

#include <array>
#include <cmath>
#include <concepts>
#include <glm/gtc/type_ptr.hpp>
#include <limits>

#include "geometry/ray.hpp"
#include "geometry/triangle.hpp"
#include "math/interval.hpp"
#include "math/vector.hpp"

namespace sr {

/// The points between two corners, faces included. A fresh one is empty and grows by `include`.
template <std::floating_point T>
struct Box {
    Vector3<T> min{std::numeric_limits<T>::infinity()};
    Vector3<T> max{-std::numeric_limits<T>::infinity()};

    void include(const Vector3<T>& point) {
        min = glm::min(min, point);
        max = glm::max(max, point);
    }
    void include(const Box& box) {
        min = glm::min(min, box.min);
        max = glm::max(max, box.max);
    }

    [[nodiscard]] Vector3<T> centre() const { return (min + max) / T{2}; }
    [[nodiscard]] Vector3<T> size() const { return max - min; }

    /// Half the surface, to which the chance that a random line meets the box is proportional; 0 if empty.
    [[nodiscard]] T half_area() const {
        const Vector3<T> s = glm::max(size(), Vector3<T>(0));
        return s.x * s.y + s.y * s.z + s.z * s.x;
    }
};

template <std::floating_point T>
[[nodiscard]] Box<T> bounds(const Triangle<T>& triangle) {
    Box<T> box;
    box.include(triangle.a);
    box.include(triangle.b);
    box.include(triangle.c);
    return box;
}

/// A ray made ready for many boxes.
template <std::floating_point T>
class BoxRay {
public:
    explicit BoxRay(const Ray<T>& ray) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto axis    = glm::length_t(k);
            const T    inverse = T{1} / ray.direction[axis];
            // The sign of 1 / d, because -0 < 0 is false although 1 / -0 is minus infinity.
            const bool backwards = std::signbit(inverse);
            slabs_[k]            = {.origin  = ray.origin[axis],
                                    .inverse = inverse,
                                    .padded  = inverse * padding,
                                    .near    = backwards ? 3 + k : k,
                                    .far     = backwards ? k : 3 + k};
        }
    }

    /// The part of `range` between the box's slabs: empty where the ray misses. The far end is lengthened by
    /// more than rounding can have shortened it, so that no triangle in the box is lost.
    ///
    /// A ray in the plane of a face gives 0 * infinity: the comparisons are written so that this NaN changes
    /// nothing, and the box is closed.
    /// @pre range.min >= 0
    /// @see Ize, Robust BVH Ray Traversal, JCGT 2(2), 2013; Williams et al., An Efficient and Robust Ray-Box
    ///      Intersection Algorithm, JGT 10(1), 2005
    [[nodiscard, gnu::always_inline]] Interval<T> clip(const Box<T>& box, Interval<T> range) const {
        const T* corners = glm::value_ptr(box.min);  // min x, y, z, max x, y, z
        return clip(slabs_[2], corners, clip(slabs_[1], corners, clip(slabs_[0], corners, range)));
    }

private:
    static constexpr T padding = 1 + 16 * std::numeric_limits<T>::epsilon();
    static_assert(padding >= 1 + 3 * std::numeric_limits<T>::epsilon(), "(4.5): three roundings each way");

    /// What one axis needs: which of a box's corner coordinates the ray meets first, and how t follows from it.
    struct Slab {
        T           origin, inverse, padded;
        std::size_t near, far;
    };

    /// One slab, equation (4.2), and what it leaves of the last entry and the first exit so far, (4.3).
    [[gnu::always_inline]] static Interval<T> clip(const Slab& slab, const T* corners, Interval<T> range) {
        const T near = (corners[slab.near] - slab.origin) * slab.inverse;
        const T far  = (corners[slab.far] - slab.origin) * slab.padded;
        return {near > range.min ? near : range.min, far < range.max ? far : range.max};
    }

    std::array<Slab, 3> slabs_;
};

}  // namespace sr
