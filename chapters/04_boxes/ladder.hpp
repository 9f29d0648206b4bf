#pragma once
/// @file ladder.hpp
/// Rays per second and seconds to build against the number of triangles, for each rung of the ladder.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "course/chapter.hpp"
#include "geometry/hierarchy.hpp"
#include "scene/teapot.hpp"
#include "work.hpp"

namespace sr {

/// What one method needed.
struct Climb {
    std::string method;
    double      seconds, build_seconds;  ///< for a ray, for the hierarchy
    double      slowest;                 ///< of the runs, seconds for a ray
    double      error, error_se;         ///< share of rays that it answers unlike brute force
};

/// How long the climb of a mesh takes, relative to other meshes; as measured once, for the progress alone.
[[nodiscard]] inline int expected_cost(const Mesh<float>& mesh) {
    const auto n        = int(mesh.faces.size());
    const int  asking   = 250 * std::min(n, 250);   // all triangles: from then on, by fewer rays
    const int  building = n > 300'000 ? n / 4 : n;  // once, or again and again
    return 7'000 + asking + building;
}

/// Every n-th face of a mesh.
[[nodiscard]] inline Mesh<float> thinned(const Mesh<float>& mesh, std::size_t count) {
    Mesh<float> result{mesh.vertices, {}};
    for (std::size_t i = 0; i < count; ++i) result.faces.push_back(mesh.faces[i * mesh.faces.size() / count]);
    return result;
}

/// Rays along random lines that meet the box around the mesh.
[[nodiscard]] inline std::vector<Ray<float>> rays_at(const Mesh<float>& mesh, std::size_t count,
                                                     std::uint64_t seed) {
    Box<float> box;
    for (std::size_t face = 0; face < mesh.faces.size(); ++face) box.include(bounds(mesh.triangle(face)));
    const auto              ball = ball_around(box);
    std::vector<Ray<float>> rays;
    for (int i = 0; rays.size() < count; ++i) {
        Rng              rng{seed, i, 0, 0};
        const Ray<float> ray = to_float(isotropic_line(ball, rng));
        if (!BoxRay<float>(ray).clip(box, in_front<float>).empty()) rays.push_back(ray);
    }
    return rays;
}

/// A mesh that is asked by all rungs, one thread.
class Ladder {
public:
    Ladder(Mesh<float> mesh, const course::Options& options)
        : mesh_(std::move(mesh)),
          draft_(options.quality == course::Quality::draft),
          rays_(rays_at(mesh_, draft_ ? 2000 : 40'000, options.seed)) {}

    /// By each rung, by the core's choice, and last by asking all triangles.
    [[nodiscard]] std::vector<Climb> climb() const {
        const BruteForce<float>                      all(mesh_);
        std::vector<std::optional<Hierarchy<float>>> built(rungs.size() + 1);
        const auto                                   asked = asked_by_all();
        std::uint64_t                                hits  = 0;  // what nobody looks at is optimised away
        const auto                                   trace = [&](const auto& surfaces, std::size_t rays) {
            for (std::size_t i = 0; i < rays; ++i) hits += surfaces.nearest(rays_[i]) ? 1U : 0U;
        };
        std::vector<course::Work> work{{"all triangles", [&] { trace(all, asked); }}};
        for (std::size_t i = 0; i < built.size(); ++i) {
            work.push_back({"build", [this, i, &built] { built[i].emplace(mesh_, options_of(i)); }});
            work.push_back({name_of(i), [this, i, &built, &trace] { trace(*built[i], rays_.size()); }});
        }
        const auto         timings = course::measure(work, draft_ || mesh_.faces.size() > 300'000 ? 1 : 5);
        std::vector<Climb> result;
        const auto         add = [&](const std::string& method, const course::Timing& rays, double count,
                             double build_seconds, std::pair<double, double> error) {
            result.push_back({method, rays.seconds / count, build_seconds, rays.slowest / count, error.first,
                              error.second});
        };
        for (std::size_t i = 0; i < built.size(); ++i)
            add(name_of(i), timings[2 + 2 * i], double(rays_.size()), timings[1 + 2 * i].seconds,
                differing(all, *built[i], asked));
        add("all triangles", timings[0], double(asked), 0, {0, 0});
        if (hits == 0) throw std::logic_error("no ray of the ladder hit its mesh");
        return result;
    }

    [[nodiscard]] std::size_t triangles() const { return mesh_.faces.size(); }

private:
    /// So many that it takes about as long as is bearable.
    [[nodiscard]] std::size_t asked_by_all() const {
        const double tests = draft_ ? 4e5 : 1e7;
        return std::clamp(std::size_t(tests / double(triangles())), std::size_t(8), rays_.size());
    }

    [[nodiscard]] static HierarchyOptions options_of(std::size_t i) {
        return i < rungs.size() ? HierarchyOptions{.cut = rungs[i].cut, .asked_straight = 0}
                                : HierarchyOptions{};
    }
    [[nodiscard]] static std::string name_of(std::size_t i) {
        return i < rungs.size() ? rungs[i].name : "the core's choice";
    }

    /// The share of rays with another hit than brute force's, and its standard error by Laplace's rule.
    [[nodiscard]] std::pair<double, double> differing(const BruteForce<float>& all,
                                                      const Hierarchy<float>&  hierarchy,
                                                      std::size_t              rays) const {
        int wrong = 0;
        for (std::size_t i = 0; i < rays; ++i)
            wrong += hierarchy.nearest(rays_[i]) == all.nearest(rays_[i]) ? 0 : 1;
        const double n = double(rays), p = (wrong + 1) / (n + 2);
        return {wrong / n, std::sqrt(p * (1 - p) / n)};
    }

    Mesh<float>             mesh_;
    bool                    draft_;
    std::vector<Ray<float>> rays_;
};

}  // namespace sr
