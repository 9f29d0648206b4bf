#pragma once
/// @file pdf.hpp

namespace sr {

/// What a density is a density of.
namespace measure {
struct Area {};        ///< [1/m^2]
struct SolidAngle {};  ///< [1/sr]
}  // namespace measure

/// A probability density whose measure is part of its type: a density of directions can't be taken for one of
/// points.
template <class Measure>
struct Pdf {
    double value = 0;
};

/// The density of the directions to points that are drawn with density `p` on a surface: dA / d(omega) = r^2 / cos.
/// @param squared_distance  r^2 to the point drawn [m^2]
/// @param cosine            between the surface's normal there and the line of sight, > 0
[[nodiscard]] constexpr Pdf<measure::SolidAngle> to_solid_angle(Pdf<measure::Area> p, double squared_distance,
                                                                double cosine) {
    return {p.value * squared_distance / cosine};
}

}  // namespace sr
