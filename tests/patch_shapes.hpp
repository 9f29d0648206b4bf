#pragma once
/// @file patch_shapes.hpp
/// Patches that tests of radiosity are made of.

#include "radiosity/polygons.hpp"

namespace sr::test {

/// [0, a] x [0, b] at the height z, its front upwards.
[[nodiscard]] inline Patch level(double a, double b, double z = 0) {
    return {{0, 0, z}, {a, 0, z}, {a, b, z}, {0, b, z}};
}

/// [0, b] x [0, h] in the plane x = 0, its front to +x.
[[nodiscard]] inline Patch upright(double b, double h) {
    return {{0, 0, 0}, {0, b, 0}, {0, b, h}, {0, 0, h}};
}

/// It reflects a half, and emits nothing.
[[nodiscard]] inline Polygon grey(const Patch& shape) {
    return {shape, {0.5, 0.5, 0.5}, {}, 0};
}

}  // namespace sr::test
