#pragma once
/// @file aligned_floor.hpp
/// The Cornell box's floor, cut along the blocks' feet before it is cut into patches.

#include <array>
#include <vector>

#include "radiosity/polygons.hpp"
#include "scene/cornell_box.hpp"

namespace sr {

using FloorQuad = std::array<Vector3<double>, 4>;

/// Whether the corner p, after o and before q, is not turned inwards, as seen from above.
[[nodiscard]] inline bool turns_outwards(const Vector3<double>& o, const Vector3<double>& p,
                                         const Vector3<double>& q) {
    return cross(p - o, q - p).y >= 0;
}

/// What is left of a quadrilateral around one in it: four more, each between two sides, or two triangles where a
/// corner of the inner one would be turned inwards. Both run the same way round, and begin at corners that are near
/// each other.
inline void cut_around(const FloorQuad& outer, const FloorQuad& inner, const Polygon& floor,
                       std::vector<Polygon>& pieces) {
    const auto add = [&](const Patch& shape) {
        pieces.push_back(floor);
        pieces.back().shape = shape;
    };
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t     j = (i + 1) % 4;
        // between two sides, in two where a corner of the inner one turns inwards
        const Vector3<double> a = outer[i], b = outer[j], c = inner[j], d = inner[i];
        if (!turns_outwards(b, c, d)) {
            add({a, b, c});
            add({a, c, d});
        } else if (!turns_outwards(c, d, a)) {
            add({a, b, d});
            add({b, c, d});
        } else {
            add({a, b, c, d});
        }
    }
}

/// The box's polygons; in place of the floor (the first) pieces around each block, and nothing below blocks.
[[nodiscard]] inline std::vector<Polygon> polygons_with_aligned_floor() {
    const auto           published = polygons_of(cornell_box());
    const Polygon&       floor     = published.front();
    const auto           p         = floor.shape.corners();  // near left, near right, far right, far left
    std::vector<Polygon> polygons;
    // between the blocks, parallel to a side of the tall one
    const auto           left = p[0] + 0.35 * (p[3] - p[0]), right = p[1] + 0.655 * (p[2] - p[1]);
    cut_around({p[0], p[1], right, left}, {{{290, 0, 114}, {130, 0, 65}, {82, 0, 225}, {240, 0, 272}}}, floor,
               polygons);
    cut_around({left, right, p[2], p[3]}, {{{423, 0, 247}, {265, 0, 296}, {314, 0, 456}, {472, 0, 406}}},
               floor, polygons);
    polygons.insert(polygons.end(), published.begin() + 1, published.end());
    return polygons;
}

}  // namespace sr
