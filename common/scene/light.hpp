#pragma once
/// @file light.hpp

#include "math/vector.hpp"
#include "radiometry/spectrum.hpp"

namespace sr {

/// A light without a size: the same intensity into all directions, hence shadows with sharp edges.
class PointLight {
public:
    /// @param intensity  flux per solid angle [W/sr]
    /// @throws std::invalid_argument if a channel of the intensity is negative or not finite, or the position is
    ///         not, also in float
    PointLight(const Vector3<double>& position, Spectrum intensity);

    [[nodiscard]] const Vector3<double>& position() const { return position_; }
    [[nodiscard]] Spectrum               intensity() const { return intensity_; }

private:
    Vector3<double> position_;
    Spectrum        intensity_;
};

}  // namespace sr
