#pragma once
/// @file vertex_radiosity.hpp
/// Radiosity that varies within patches, equation (8.23). How to use:
///     const Radiosities at_vertices = vertex_radiosities(patches, radiosities);
///     const DoubleSpectrum B = interpolated(patches, at_vertices, i, point);

#include <cstddef>

#include "radiosity/patches.hpp"
#include "radiosity/radiosity_system.hpp"

namespace sr {

/// At each vertex, the value of the plane that fits, by least squares, the radiosities of the patches around it at
/// their centres [W/m^2]. Those that touch the vertex, and at a polygon's border, where all of them lie to one side,
/// also those that touch these: so that what is linear in the polygon stays as it is. No other polygon's patches, for
/// there light jumps. Where they lie in one line, nothing is known across it, and the plane is level. Never less than
/// 0; and 0 where no patch has the vertex.
/// @see Gouraud, Continuous Shading of Curved Surfaces, IEEE Trans. Computers C-20 (1971); Cohen and Greenberg, The
///      Hemi-Cube, Computer Graphics 19(3), 1985, who take means
[[nodiscard]] Radiosities vertex_radiosities(const Patches& patches, const Radiosities& radiosities);

/// The radiosity at a point of a patch, by its corners' weights [W/m^2].
/// @param at_vertices  one for each of patches.vertices
[[nodiscard]] DoubleSpectrum interpolated(const Patches& patches, const Radiosities& at_vertices,
                                          std::size_t patch, const Vector3<double>& point);

}  // namespace sr
