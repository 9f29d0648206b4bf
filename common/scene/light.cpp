/// @file light.cpp

#include "scene/light.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace sr {

PointLight::PointLight(const Vector3<double>& position, Spectrum intensity)
    : position_{position}, intensity_{intensity} {
    const double x = position.x, y = position.y, z = position.z;
    if (!each_in(intensity, 0, std::numeric_limits<float>::max()))
        throw std::invalid_argument(
            fmt::format("intensity of a point light is ({}, {}, {}); each must be finite and not negative",
                        intensity.r, intensity.g, intensity.b));
    if (!(std::isfinite(x) && std::isfinite(y) && std::isfinite(z)))
        throw std::invalid_argument(
            fmt::format("position of a point light is ({}, {}, {}); each must be finite", x, y, z));
}

}  // namespace sr
