/// @file teapot.cpp

#include "scene/teapot.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <locale>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "scene/text_file.hpp"

namespace sr {
namespace {

using Point = Vector3<double>;
using Patch = std::array<std::array<Point, 4>, 4>;  // control points, row by row

/// The patch and its images under the symmetry that the file names. A minus is written as 0 - v, which keeps
/// the zeros positive.
std::vector<Patch> with_copies(const Patch& patch, const std::string& symmetry) {
    std::vector<Patch> all{patch};
    if (symmetry == "rotate4") {
        for (int turn = 1; turn < 4; ++turn) {
            Patch copy = all.back();
            for (auto& row : copy) {
                for (Point& p : row) p = {0 - p.y, p.x, p.z};
            }
            all.push_back(copy);
        }
    } else if (symmetry == "mirror_y") {
        Patch copy = patch;
        for (auto& row : copy) {
            for (Point& p : row) p.y = 0 - p.y;
            // a mirror turns a surface inside out, and the other direction turns it back
            std::reverse(row.begin(), row.end());
        }
        all.push_back(copy);
    } else {
        throw std::runtime_error(fmt::format("symmetry {}; must be rotate4 or mirror_y", symmetry));
    }
    return all;
}

/// The 32 patches: those of the file, each followed by its copies.
std::vector<Patch> read_patches() {
    const std::string  file = STERADIAN_SCENE_DATA "/teapot.csv";
    std::istringstream lines(read_text(file));
    std::vector<Patch> patches;
    Patch              patch;
    std::size_t        points = 0;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with('#') || line.starts_with("patch,")) continue;
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream fields(line);
        fields.imbue(std::locale::classic());  // whose decimal point is a point
        std::string part, symmetry;
        std::size_t number = 0, row = 0, column = 0;
        Point       p{};
        fields >> number >> part >> symmetry >> row >> column >> p.x >> p.y >> p.z;
        if (!fields || 16 * number + 4 * row + column != points) {
            throw std::runtime_error(
                fmt::format("{}: '{}' after {} points; must be patch, part, symmetry, row, "
                            "column, x, y, z of the next",
                            file, line, points));
        }
        patch[row][column] = p;
        if (++points % 16 != 0) continue;
        const auto copies = with_copies(patch, symmetry);
        patches.insert(patches.end(), copies.begin(), copies.end());
    }
    if (patches.size() != 32)
        throw std::runtime_error(fmt::format("{}: {} patches; must be 32", file, patches.size()));
    return patches;
}

/// The cubic Bernstein polynomials at i / n.
using Weights = std::array<double, 4>;

/// Turned round, i -> n - i, they are the same numbers to the bit, in the opposite order.
Weights bernstein(int i, int n) {
    const double s = double(i) / n;
    const double t = double(n - i) / n;
    return {t * t * t, 3 * (t * t) * s, 3 * (s * s) * t, s * s * s};
}

/// A point of a cubic Bezier curve. The sum is the same to the bit if the curve is run from its other end:
/// patches that share a border have it from opposite ends.
Point on_curve(const std::array<Point, 4>& p, const Weights& w) {
    return (w[0] * p[0] + w[3] * p[3]) + (w[1] * p[1] + w[2] * p[2]);
}

/// Cuts patches into triangles and joins them where they meet.
class Tessellation {
public:
    explicit Tessellation(int level) : n_{std::size_t(level)} {
        for (int i = 0; i <= level; ++i) weights_.push_back(bernstein(i, level));
        mesh_.vertices.reserve(32 * n_ * n_ + 4 * n_ + 1);
        mesh_.faces.reserve(64 * n_ * n_);
    }

    void add(const Patch& patch) {
        std::vector<std::uint32_t> grid;
        grid.reserve((n_ + 1) * (n_ + 1));
        for (std::size_t i = 0; i <= n_; ++i) {
            for (std::size_t j = 0; j <= n_; ++j) grid.push_back(vertex(patch, i, j));
        }
        // in every patch of the file, rows x columns points inwards: so the faces go down the columns first
        for (std::size_t i = 0; i < n_; ++i) {
            for (std::size_t j = 0; j < n_; ++j) {
                const std::size_t corner = i * (n_ + 1) + j;
                const auto        a = grid[corner], b = grid[corner + 1], c = grid[corner + n_ + 2],
                           d = grid[corner + n_ + 1];
                add_face({a, b, c});
                add_face({a, c, d});
            }
        }
    }

    [[nodiscard]] Mesh<double> take() && { return std::move(mesh_); }

private:
    [[nodiscard]] Point position(const Patch& patch, std::size_t i, std::size_t j) const {
        // The poles. The lid's is drawn out to a loop of size 0.002, to have a tangent for the normal; as
        // triangles that would be a hole in the tip.
        if (i == 0 && patch[0][0] == patch[0][3]) return patch[0][0];
        std::array<Point, 4> across;
        for (std::size_t row = 0; row < 4; ++row) across[row] = on_curve(patch[row], weights_[j]);
        return on_curve(across, weights_[i]);
    }

    /// A vertex of its own inside a patch; on its border the one that is at this position already, if any.
    std::uint32_t vertex(const Patch& patch, std::size_t i, std::size_t j) {
        const Point p    = position(patch, i, j);
        const auto  next = std::uint32_t(mesh_.vertices.size());
        if (i == 0 || i == n_ || j == 0 || j == n_) {
            const auto [known, is_new] = border_.try_emplace({p.x, p.y, p.z}, next);
            if (!is_new) return known->second;
        }
        mesh_.vertices.push_back(p);
        return next;
    }

    /// Not at a pole, where two corners are one, nor the lip of a spout that level 1 makes flat.
    void add_face(const Mesh<double>::Face& face) {
        const Triangle<double> t{mesh_.vertices[face[0]], mesh_.vertices[face[1]], mesh_.vertices[face[2]]};
        if (area_vector(t) != Point{}) mesh_.faces.push_back(face);
    }

    std::size_t                                    n_;
    std::vector<Weights>                           weights_;
    std::map<std::array<double, 3>, std::uint32_t> border_;
    Mesh<double>                                   mesh_;
};

}  // namespace

Mesh<double> teapot(int level) {
    if (level < 1 || level > max_teapot_level) {
        throw std::invalid_argument(fmt::format("teapot level {}: must be 1 to {}", level, max_teapot_level));
    }
    Tessellation tessellation(level);
    for (const Patch& patch : read_patches()) tessellation.add(patch);
    return std::move(tessellation).take();
}

}  // namespace sr
