/// @file light.cpp

#include "scene/light.hpp"

#include <fmt/format.h>

#include <limits>
#include <stdexcept>

#include "math/finite_in_float.hpp"

namespace sr {

PointLight::PointLight(const Vector3<double>& position, Spectrum intensity)
    : position_{position}, intensity_{intensity} {
    if (!each_in(intensity, 0, std::numeric_limits<float>::max()))
        throw std::invalid_argument(
            fmt::format("intensity of a point light is ({}, {}, {}); each must be finite and not negative",
                        intensity.r, intensity.g, intensity.b));
    if (!finite_in_float(position))
        throw std::invalid_argument(
            fmt::format("position of a point light is ({}, {}, {}); each must be finite, also in float",
                        position.x, position.y, position.z));
}

}  // namespace sr
