#pragma once
/// @file planet.hpp
/// Somebody stands on a sphere and looks down: four ways to know how high above the ground he is.

#include <cmath>
#include <concepts>

#include "each_ray.hpp"
#include "geometry/ray.hpp"
#include "geometry/sphere.hpp"
#include "math/difference_of_squares.hpp"
#include "math/vector.hpp"
#include "sampling/ball.hpp"
#include "sampling/rng.hpp"
#include "statistics/estimate.hpp"
#include "textbook_sphere.hpp"

namespace sr {

/// The constant term of (2.4) from s = o - c.
struct PlainConstant {
    template <std::floating_point T>
    T operator()(const Vector3<T>& s, T r) const {
        return dot(s, s) - r * r;
    }
};
/// (2.15)
struct FactoredConstant {
    template <std::floating_point T>
    T operator()(const Vector3<T>& s, T r) const {
        return (length(s) - r) * (length(s) + r);
    }
};
struct CompensatedConstant {
    template <std::floating_point T>
    T operator()(const Vector3<T>& s, T r) const {
        return difference_of_squares(s, r);
    }
};

/// The near root of (2.4) from outside, with (2.5) for the discriminant, and the constant term of this kind.
template <class Constant, std::floating_point T>
[[nodiscard]] T ground_below(const Sphere<T>& sphere, const Ray<T>& ray, const Constant& constant) {
    const Vector3<T> s    = ray.origin - sphere.centre;
    const T          a    = dot(ray.direction, ray.direction);
    const T          b    = dot(s, ray.direction);
    const Vector3<T> foot = s - (b / a) * ray.direction;
    const T          root = std::sqrt(a * (sphere.radius * sphere.radius - dot(foot, foot)));
    return constant(s, sphere.radius) / (root - b);
}

/// The school's near root.
[[nodiscard]] inline float ground_below_at_school(const Sphere<float>& sphere, const Ray<float>& ray) {
    const auto roots = textbook_crossings(sphere, ray);
    return roots ? roots->first : -1;
}

/// Where the camera is: where one coordinate is the height, or where it is a mixture of three.
enum class Place { pole, anywhere };

/// The median of |t / true t - 1| [%] over rays within 60 degrees of straight down, from a height of 1.
template <class Method>
[[nodiscard]] Estimate median_error_on_planet(float radius, Place place, int rays, int threads,
                                              const Method& method) {
    const Sphere<float> planet{{0, 0, 0}, radius};
    const auto          errors = each_ray(rays, threads, [&](int i) {
        Rng  rng{2, i, 0, 0};
        Vec3 up{0, 0, 1};
        if (place == Place::anywhere) up = normalize(in_unit_ball<float>(rng));
        Vec3 d = up;
        while (dot(d, up) > -0.5F * length(d)) d = in_unit_ball<float>(rng);
        const Ray<float> ray{(radius + 1) * up, normalize(d)};

        const Sphere<double> exact_planet{{0, 0, 0}, radius};
        const Ray<double>    exact_ray{ray.origin, ray.direction};
        const double         exact = ground_below(exact_planet, exact_ray, CompensatedConstant{});
        return std::abs(double(method(planet, ray)) / exact - 1);
    });
    return percent(median(errors));
}

}  // namespace sr
