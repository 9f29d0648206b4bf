/// @file vertex_radiosity.cpp

#include "radiosity/vertex_radiosity.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <set>

#include "math/frame.hpp"
#include "radiosity/corner_weights.hpp"

namespace sr {
namespace {

using Point   = Vector3<double>;
using Indices = std::vector<std::uint32_t>;  // of patches

std::vector<Indices> patches_at_vertices(const Patches& patches) {
    std::vector<Indices> touching(patches.vertices.size());
    for (std::uint32_t i = 0; i < patches.size(); ++i) {
        const auto& corners = patches.corners[i];
        const auto  count   = patches.shapes[i].corners().size();
        for (std::size_t k = 0; k < count; ++k) touching[corners[k]].push_back(i);
    }
    return touching;
}

/// The angle of a patch's corner at the point [rad].
double angle_at(const Patch& shape, const Point& point) {
    const auto  p = shape.corners();
    std::size_t k = 0;
    while (k + 1 < p.size() && p[k] != point) ++k;
    const Vector3<double> u = p[(k + 1) % p.size()] - p[k], v = p[(k + p.size() - 1) % p.size()] - p[k];
    return std::atan2(length(cross(u, v)), dot(u, v));
}

/// Whether the patches that touch the point surround it.
bool is_surrounded(const Patches& patches, const Indices& touching, const Point& point) {
    double sum = 0;
    for (const auto i : touching) sum += angle_at(patches.shapes[i], point);
    return sum > 2 * std::numbers::pi * (1 - 1e-6);
}

/// These patches, and all that share a vertex with one of them.
Indices with_neighbours(const Patches& patches, const std::vector<Indices>& at_vertices,
                        const Indices& some) {
    std::set<std::uint32_t> all;
    for (const auto i : some)
        for (const auto vertex : patches.corners[i])
            all.insert(at_vertices[vertex].begin(), at_vertices[vertex].end());
    return {all.begin(), all.end()};
}

/// The value at a point of the plane through the patches' radiosities.
DoubleSpectrum fitted(const Patches& patches, const Radiosities& radiosities, const Indices& around,
                      const Point& point) {
    const double   share = 1 / double(around.size());
    Point          middle{0, 0, 0};
    DoubleSpectrum value;
    for (const auto i : around) {
        middle += share * patches.shapes[i].centre();
        value = value + share * radiosities[i];
    }
    const auto frame = frame_around(patches.shapes[around.front()].normal());
    double     xx = 0, xy = 0, yy = 0;  // second moments of the centres about their middle
    for (const auto i : around) {
        const auto d = frame.to_local(patches.shapes[i].centre() - middle);
        xx += d.x * d.x;
        xy += d.x * d.y;
        yy += d.y * d.y;
    }
    // along the axes of the moments' ellipse, the slopes do not depend on each other
    const double          angle = std::atan2(2 * xy, xx - yy) / 2, spread = std::hypot((xx - yy) / 2, xy);
    const Vector3<double> axes[]    = {std::cos(angle) * frame.s + std::sin(angle) * frame.t,
                                       std::cos(angle) * frame.t - std::sin(angle) * frame.s};
    const double          moments[] = {(xx + yy) / 2 + spread, (xx + yy) / 2 - spread};
    for (const int axis : {0, 1}) {
        if (!(moments[axis] > 1e-12 * moments[0])) continue;  // all in one line, or only one patch
        const double at = dot(point - middle, axes[axis]) / moments[axis];
        for (const auto i : around)
            value = value + at * dot(patches.shapes[i].centre() - middle, axes[axis]) * radiosities[i];
    }
    return value;
}

double not_below_zero(double value) {
    return value < 0 ? 0 : value;  // and NaN stays
}

}  // namespace

Radiosities vertex_radiosities(const Patches& patches, const Radiosities& radiosities) {
    const auto  touching = patches_at_vertices(patches);
    Radiosities values;
    for (std::size_t vertex = 0; vertex < patches.vertices.size(); ++vertex) {
        if (touching[vertex].empty()) {  // of a piece that had no area
            values.push_back({});
            continue;
        }
        const auto&          point = patches.vertices[vertex];
        const DoubleSpectrum B =
            is_surrounded(patches, touching[vertex], point)
                ? fitted(patches, radiosities, touching[vertex], point)
                : fitted(patches, radiosities, with_neighbours(patches, touching, touching[vertex]), point);
        values.push_back({not_below_zero(B.r), not_below_zero(B.g), not_below_zero(B.b)});
    }
    return values;
}

DoubleSpectrum interpolated(const Patches& patches, const Radiosities& at_vertices, std::size_t patch,
                            const Vector3<double>& point) {
    const auto     weights = corner_weights(patches.shapes[patch], point);
    DoubleSpectrum sum;
    for (std::size_t k = 0; k < 4; ++k) sum = sum + weights[k] * at_vertices[patches.corners[patch][k]];
    return sum;
}

}  // namespace sr
