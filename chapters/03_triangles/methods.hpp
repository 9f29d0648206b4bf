#pragma once
/// @file methods.hpp
/// The ways to intersect a triangle behind one face: what is made ready of a triangle, what of a ray, and the test.

#include <concepts>
#include <optional>
#include <vector>

#include "as_published.hpp"
#include "geometry/mesh.hpp"
#include "geometry/moeller_trumbore.hpp"
#include "geometry/plane_triangle.hpp"
#include "geometry/triangle.hpp"

namespace sr {

/// Section 3.2: nothing is made ready.
template <std::floating_point T>
struct Cramer {
    static constexpr const char* name = "Cramer";
    using ReadyTriangle               = Triangle<T>;
    using ReadyRay                    = Ray<T>;
    static std::optional<Hit<T>> intersect(const ReadyTriangle& triangle, const ReadyRay& ray,
                                           Interval<T> range) {
        return intersect_moeller_trumbore(triangle, ray, range);
    }
};

/// Section 3.3: the triangle is.
template <std::floating_point T>
struct Planes {
    static constexpr const char* name = "plane and edges";
    using ReadyTriangle               = PlaneTriangle<T>;
    using ReadyRay                    = Ray<T>;
    static std::optional<Hit<T>> intersect(const ReadyTriangle& triangle, const ReadyRay& ray,
                                           Interval<T> range) {
        return triangle.intersect(ray, range);
    }
};

/// Section 3.5: the ray is.
template <std::floating_point T>
struct Watertight {
    static constexpr const char* name = "watertight";
    using ReadyTriangle               = Triangle<T>;
    using ReadyRay                    = TriangleRay<T>;
    static std::optional<Hit<T>> intersect(const ReadyTriangle& triangle, const ReadyRay& ray,
                                           Interval<T> range) {
        return ray.intersect(triangle, range);
    }
};

/// The same as it was published.
template <std::floating_point T>
struct Published {
    static constexpr const char* name = "as published";
    using ReadyTriangle               = Triangle<T>;
    using ReadyRay                    = PublishedRay<T>;
    static std::optional<Hit<T>> intersect(const ReadyTriangle& triangle, const ReadyRay& ray,
                                           Interval<T> range) {
        return ray.intersect(triangle, range);
    }
};

/// Calls use(method) for each, in the order of the sections.
template <std::floating_point T, class Use>
void for_each_method(Use&& use) {
    use(Cramer<T>{});
    use(Planes<T>{});
    use(Published<T>{});
    use(Watertight<T>{});
}
inline constexpr std::size_t method_count = 4;

template <class Method, std::floating_point T>
[[nodiscard]] std::vector<typename Method::ReadyTriangle> made_ready(const Mesh<T>& mesh) {
    std::vector<typename Method::ReadyTriangle> ready;
    for (std::size_t face = 0; face < mesh.faces.size(); ++face)
        ready.push_back(typename Method::ReadyTriangle(mesh.triangle(face)));
    return ready;
}

}  // namespace sr
