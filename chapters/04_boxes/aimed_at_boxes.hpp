#pragma once
/// @file aimed_at_boxes.hpp
/// Rays aimed at a place of a small box, or at a mesh's vertices, and how many hits are lost to rounding.

#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "geometry/mesh.hpp"
#include "geometry/triangle.hpp"
#include "sampling/rng.hpp"
#include "textbook_slabs.hpp"
#include "transport/tiles.hpp"

namespace sr {

enum class BoxPart { corner, edge, interior };

/// A box, and a ray towards it.
struct AimedRay {
    Ray<float> ray;
    Box<float> box;
};

/// A box at coordinates up to 10, its sides at most `size`, and a ray from a point of the same space.
[[nodiscard]] inline AimedRay aimed_at_box(BoxPart part, double size, Rng& rng) {
    const auto uniform = [&](double low, double high) { return low + (high - low) * rng.uniform<double>(); };
    AimedRay   result;
    Vec3       target;
    const int  free_axis = int(uniform(0, 3));  // along an edge
    for (int axis = 0; axis < 3; ++axis) {
        result.ray.origin[axis] = float(uniform(-10, 10));
        result.box.min[axis]    = float(uniform(-10, 10));
        result.box.max[axis]    = float(result.box.min[axis] + uniform(0, size));
        const double between    = uniform(0, 1);
        const bool   free       = part == BoxPart::interior || (part == BoxPart::edge && axis == free_axis);
        const double share      = free ? between : between < 0.5 ? 0 : 1;
        target[axis] =
            float(result.box.min[axis] + share * (double(result.box.max[axis]) - result.box.min[axis]));
    }
    result.ray.direction = normalize(target - result.ray.origin);
    return result;
}

/// Whether the ray meets the box, by arithmetic with 11 more bits, or 29 where long double is double.
[[nodiscard]] inline bool truly_hits(const AimedRay& aimed) {
    using Exact = long double;
    const Ray<Exact> ray{Vector3<Exact>(aimed.ray.origin), Vector3<Exact>(aimed.ray.direction)};
    const Box<Exact> box{Vector3<Exact>(aimed.box.min), Vector3<Exact>(aimed.box.max)};
    return !padded_clip<Exact>(ray, box, 1).empty();
}

/// True hits that tests in float miss, as shares of all true hits [%].
struct LostHits {
    std::vector<double> padded;  ///< with exits lengthened by each of some paddings
    double              core;    ///< by BoxRay
    int                 hits;    ///< how many true hits there were

    /// Of one of the shares; 0 where nothing was lost.
    [[nodiscard]] double standard_error(std::size_t padding) const {
        return std::sqrt(padded[padding] * (100 - padded[padding]) / hits);
    }
};

/// Counts who misses what; any number of threads may ask.
class LossCounter {
public:
    /// @param paddings  factors of the exits; between two floats, too, so that a curve can be drawn
    explicit LossCounter(std::vector<double> paddings)
        : paddings_(std::move(paddings)), lost_(paddings_.size()) {}

    /// The products with paddings between two floats are compared in double.
    /// @pre the ray does hit the box
    void count(const Ray<float>& ray, const Box<float>& box) {
        ++truly_;
        if (BoxRay<float>(ray).clip(box, in_front<float>).empty()) ++by_core_;
        const Interval<float> plain = padded_clip(ray, box, 1.0F);
        if (!plain.empty()) return;
        for (std::size_t i = 0; i < paddings_.size(); ++i)
            if (!(double(plain.min) <= double(plain.max) * paddings_[i])) ++lost_[i];
    }
    [[nodiscard]] LostHits percent() const {
        LostHits result{{}, 100.0 * by_core_ / truly_, truly_};
        for (const auto& lost : lost_) result.padded.push_back(100.0 * lost / truly_);
        return result;
    }

private:
    std::vector<double>           paddings_;
    std::atomic<int>              truly_ = 0, by_core_ = 0;
    std::vector<std::atomic<int>> lost_;
};

/// Rays at a place of boxes whose sides are at most `size`.
[[nodiscard]] inline LostHits lost_hits(BoxPart part, double size, int rays,
                                        const std::vector<double>& paddings, int threads) {
    constexpr int side = 64;
    LossCounter   counter(paddings);
    for_each_pixel(side, side, {.threads = threads}, [&](int x, int y) {
        Rng rng{1, x, y, 0};
        for (int i = 0; i < rays / (side * side); ++i) {
            const AimedRay aimed = aimed_at_box(part, size, rng);
            if (truly_hits(aimed)) counter.count(aimed.ray, aimed.box);
        }
    });
    return counter.percent();
}

/// Rays from around a mesh to a vertex of a random face by which they are hit, and the box of that face.
[[nodiscard]] inline LostHits lost_vertices(const Mesh<float>& mesh, const std::vector<double>& paddings,
                                            int threads) {
    constexpr int side = 512;
    LossCounter   counter(paddings);
    for_each_pixel(side, side, {.threads = threads}, [&](int x, int y) {
        Rng              rng{1, x, y, 0};
        const auto       face = std::size_t(rng.uniform<double>() * double(mesh.faces.size()));
        const float      a = rng.uniform(), b = rng.uniform(), c = rng.uniform();
        const Vec3       o        = 20.0F * Vec3{a, b, c} - 10.0F;
        const auto       triangle = mesh.triangle(face);
        const Ray<float> ray{o, normalize(triangle.a - o)};
        if (TriangleRay<float>(ray).intersect(triangle, in_front<float>))
            counter.count(ray, bounds(triangle));
    });
    return counter.percent();
}

}  // namespace sr
