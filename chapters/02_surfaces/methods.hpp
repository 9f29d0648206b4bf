#pragma once
/// @file methods.hpp
/// The ways to find a ray's first root against the clock and against the truth, for the charts of section 2.5.

#include <cmath>
#include <concepts>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "course/chapter.hpp"
#include "geometry/implicit_closed_form.hpp"
#include "geometry/implicit_intervals.hpp"
#include "geometry/implicit_marching.hpp"
#include "geometry/implicit_segment_tracing.hpp"
#include "geometry/implicit_sphere_tracing.hpp"
#include "sampling/rng.hpp"
#include "statistics/estimate.hpp"
#include "textbook_quartic.hpp"
#include "transport/tiles.hpp"

namespace sr {

/// A method at one effort, which is a step or a tolerance in units of length, or 0 where there is nothing to choose.
struct Method {
    std::string                                            name;
    double                                                 effort;
    std::function<std::optional<float>(const Ray<float>&)> first_root;
};

/// What a method got wrong, of random rays.
struct Score {
    double   missed   = 0;   ///< the first root [share of all rays]
    double   invented = 0;   ///< a root where there is none, or before the first one [share of all rays]
    Estimate wrong    = {};  ///< missed + invented
    Estimate t_error  = {};  ///< of the first roots that it found, the median [length]
};

/// Random rays towards a surface, in float, and where in truth they meet it first.
class Race {
public:
    /// @param exact  the same surface in double, whose roots intervals prove
    template <class Surface, class Exact>
    Race(const Surface& surface, const Exact& exact, int rays, const course::Options& options)
        : threads_(options.threads), rays_(std::size_t(rays)), truth_(std::size_t(rays)) {
        const Box<float> box = surface.bounds();
        each([&](std::size_t i) {
            rays_[i] = towards(box, Rng{3, std::int64_t(i), 0, 0});
            const Ray<double> ray{rays_[i].origin, rays_[i].direction};
            truth_[i] = bisect_intervals(exact, ray, in_front<double>, 1e-12);
        });
    }

    [[nodiscard]] const std::vector<Ray<float>>& rays() const { return rays_; }

    [[nodiscard]] Score score(const Method& method) const {
        std::vector<std::optional<float>> found(rays_.size());
        each([&](std::size_t i) { found[i] = method.first_root(rays_[i]); });
        int                 missed = 0, invented = 0;
        std::vector<double> errors;
        for (std::size_t i = 0; i < rays_.size(); ++i) {
            const auto& truth = truth_[i];
            if (!truth || (found[i] && *found[i] < *truth - another_root)) {
                invented += found[i] ? 1 : 0;
            } else if (!found[i] || *found[i] > *truth + another_root) {
                ++missed;
            } else {
                errors.push_back(std::abs(*found[i] - *truth));
            }
        }
        const double n = double(rays_.size());
        return {missed / n, invented / n, share(missed + invented, rays_.size()), median(errors)};
    }

private:
    // [length] What is farther from the first root is not that root known badly, but another one, or none. It is
    // three times the widest piece that intervals are left in doubt about.
    static constexpr double another_root = 0.3;

    /// From a sphere of radius 6 to a point of the box, with a direction of length 1: t is a length.
    static Ray<float> towards(const Box<float>& box, Rng rng) {
        Vector3<double> from, to;
        for (int axis = 0; axis < 3; ++axis) from[axis] = rng.uniform<double>() - 0.5;
        for (int axis = 0; axis < 3; ++axis) to[axis] = rng.uniform<double>();
        from = 6.0 * normalize(from);
        to   = Vector3<double>(box.min) + to * Vector3<double>(box.size());
        return {from, normalize(to - from)};
    }

    void each(const std::function<void(std::size_t)>& of) const {
        constexpr int row = 64;
        const int     n   = int(rays_.size());
        for_each_pixel(row, n / row, {.threads = threads_},
                       [&](int x, int y) { of(std::size_t(y) * row + std::size_t(x)); });
    }

    int                                threads_;
    std::vector<Ray<float>>            rays_;
    std::vector<std::optional<double>> truth_;
};

/// The first root by Ferrari's formula.
template <class Surface>
[[nodiscard]] std::optional<float> solve_by_ferrari(const Surface& surface, const Ray<float>& ray) {
    const auto part = within_bounds(surface, ray, in_front<float>);
    if (!part) return std::nullopt;
    std::optional<float> first;
    for (const float t : textbook_quartic_roots(on_ray(surface, ray, Polynomial<float, 1>{{0, 1}}))) {
        if (part->contains(t) && !(first && *first <= t)) first = t;
    }
    return first;
}

/// All methods for a surface, each at all of its efforts.
template <class Surface>
[[nodiscard]] std::vector<Method> all_methods(const Surface& surface) {
    std::vector<Method> methods;
    for (const float step : {1.0F, 0.5F, 0.2F, 0.1F, 0.05F, 0.02F, 0.01F})
        methods.push_back({"fixed steps", step, [=](const Ray<float>& ray) {
                               return march(surface, ray, in_front<float>, step);
                           }});
    const float lipschitz = lipschitz_bound(surface, surface.bounds());
    for (const float tolerance : {1e-2F, 1e-3F, 1e-4F, 1e-5F})
        methods.push_back({"sphere tracing", tolerance, [=](const Ray<float>& ray) {
                               return sphere_trace(surface, ray, in_front<float>, lipschitz, tolerance);
                           }});
    for (const float tolerance : {1e-2F, 1e-3F, 1e-4F})
        methods.push_back({"segment tracing", tolerance, [=](const Ray<float>& ray) {
                               return segment_trace(surface, ray, in_front<float>, tolerance);
                           }});
    for (const float width : {1e-1F, 1e-3F, 1e-5F})
        methods.push_back({"intervals", width, [=](const Ray<float>& ray) {
                               return bisect_intervals(surface, ray, in_front<float>, width);
                           }});
    if constexpr (AlgebraicSurface<Surface, float>) {
        methods.push_back({"isolated roots", 0,
                           [=](const Ray<float>& ray) { return solve(surface, ray, in_front<float>); }});
        methods.push_back(
            {"Ferrari", 0, [=](const Ray<float>& ray) { return solve_by_ferrari(surface, ray); }});
    }
    return methods;
}

}  // namespace sr
