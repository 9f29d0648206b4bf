#pragma once
/// @file polygons.hpp

#include <vector>

#include "radiometry/spectrum.hpp"
#include "radiosity/patch.hpp"
#include "scene/scene.hpp"

namespace sr {

/// A diffuse surface as radiosity sees it, before it is cut into patches.
struct Polygon {
    Patch          shape;
    DoubleSpectrum reflectance;  ///< [1]
    DoubleSpectrum emission;     ///< radiosity, pi times the emitted radiance [W/m^2]
    std::uint32_t  material;     ///< in the scene
};

/// Which sides of a face shine: that to which its normal points, or both as if it were two sheets of paper. A room
/// whose faces look outwards has form factors of 0 with `front`: its light stays behind them.
enum class ShiningSides { front, both };

/// A scene's faces. Two triangles (a, b, c), (a, c, d) that follow each other, are of one material and make up a flat
/// convex quadrilateral are one polygon. Faces without an area are left out: no light gets there or comes from there.
/// @throws std::invalid_argument if there is what radiosity can't do: a material that is not diffuse (which one, and
///         what is made for it), a ball, a point light, a background that shines, no face at all
[[nodiscard]] std::vector<Polygon> polygons_of(const Scene& scene, ShiningSides sides = ShiningSides::front);

}  // namespace sr
