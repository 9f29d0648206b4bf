/// @file patches.cpp

#include "radiosity/patches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "geometry/triangle.hpp"

namespace sr {
namespace {

/// In how many pieces lengths are cut.
struct Pieces {
    double along, across;
};

Pieces pieces(const Patch& shape, double size) {
    const auto p = shape.corners();
    const auto n = [&](double longest) { return std::max(1.0, std::ceil(longest / size * (1 - 1e-12))); };
    if (p.size() == 3) return {n(shape.longest_side()), n(shape.longest_side())};
    return {n(std::max(length(p[1] - p[0]), length(p[2] - p[3]))),
            n(std::max(length(p[2] - p[1]), length(p[3] - p[0])))};
}

/// Adds patches of one polygon after the other.
class Cutter {
public:
    void cut(const Polygon& polygon, const Pieces& pieces) {
        if (polygon.shape.corners().size() == 3)
            cut_triangle(polygon, std::uint32_t(pieces.along));
        else
            cut_quadrilateral(polygon, std::uint32_t(pieces.along), std::uint32_t(pieces.across));
        ++polygons_;
    }
    [[nodiscard]] Patches take() { return std::move(patches_); }

private:
    using Index = std::uint32_t;

    void cut_quadrilateral(const Polygon& polygon, Index along, Index across) {
        const Index first = vertex_count();
        for (Index j = 0; j <= across; ++j)
            for (Index i = 0; i <= along; ++i)
                patches_.vertices.push_back(polygon.shape.at({i / double(along), j / double(across)}));
        const auto at = [&](Index i, Index j) { return first + j * (along + 1) + i; };
        for (Index j = 0; j < across; ++j)
            for (Index i = 0; i < along; ++i)
                add(polygon, {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }

    /// Rows of n, n - 1, ... 1 triangles that stand as the large one does, and between them those upside down.
    void cut_triangle(const Polygon& polygon, Index n) {
        const Index first = vertex_count();
        const auto  p     = polygon.shape.corners();
        for (Index j = 0; j <= n; ++j)
            for (Index i = 0; i <= n - j; ++i)
                patches_.vertices.push_back((double(n - i - j) * p[0] + double(i) * p[1] + double(j) * p[2]) /
                                            double(n));
        const auto at = [&](Index i, Index j) { return first + j * (2 * n + 3 - j) / 2 + i; };
        for (Index j = 0; j < n; ++j)
            for (Index i = 0; i < n - j; ++i) {
                add(polygon, {at(i, j), at(i + 1, j), at(i, j + 1), at(i, j + 1)});
                if (i + 1 < n - j) add(polygon, {at(i + 1, j + 1), at(i, j + 1), at(i + 1, j), at(i + 1, j)});
            }
    }

    /// Adds a piece, unless its corners have rounded to a line.
    void add(const Polygon& polygon, const Patches::Corners& corners) {
        const auto& [a, b, c, d] = corners;
        const auto& v            = patches_.vertices;
        const bool  three        = c == d;
        if (!(area<double>({v[a], v[b], v[c]}) + area<double>({v[a], v[c], v[d]}) > 0)) return;
        if (!three && !make_a_quadrilateral({v[a], v[b], v[c], v[d]})) return;
        patches_.corners.push_back(corners);
        patches_.shapes.push_back(three ? Patch{v[a], v[b], v[c]} : Patch{v[a], v[b], v[c], v[d]});
        patches_.reflectance.push_back(polygon.reflectance);
        patches_.emission.push_back(polygon.emission);
        patches_.polygon.push_back(polygons_);
    }

    [[nodiscard]] Index vertex_count() const { return Index(patches_.vertices.size()); }

    Patches patches_;
    Index   polygons_ = 0;
};

}  // namespace

Patches cut(std::span<const Polygon> polygons, double size) {
    if (!(size > 0))
        throw std::invalid_argument(fmt::format("the patches' size is {}; must be above 0", size));
    double count = 0;
    for (const auto& polygon : polygons) {
        const Pieces n = pieces(polygon.shape, size);
        count += n.along * n.across;
    }
    if (!(count <= most_patches))
        throw std::invalid_argument(
            fmt::format("the patches' size is {}, which makes {:.3g} of them; make it larger: "
                        "{:.3g} are the most",
                        size, count, most_patches));
    Cutter cutter;
    for (const auto& polygon : polygons) cutter.cut(polygon, pieces(polygon.shape, size));
    return cutter.take();
}

PatchMesh mesh_of(const Patches& patches) {
    PatchMesh result{{patches.vertices, {}}, {}};
    for (std::uint32_t i = 0; i < patches.size(); ++i) {
        const auto& [a, b, c, d] = patches.corners[i];
        result.mesh.faces.push_back({a, b, c});
        result.patch_of_face.push_back(i);
        if (c == d) continue;
        result.mesh.faces.push_back({a, c, d});
        result.patch_of_face.push_back(i);
    }
    return result;
}

}  // namespace sr
