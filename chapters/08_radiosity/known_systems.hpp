#pragma once
/// @file known_systems.hpp
/// Small systems whose solution is known. All are grey: the three primaries are the same.

#include <cmath>
#include <cstddef>
#include <vector>

#include "math/square.hpp"
#include "radiosity/closed_form_factors.hpp"
#include "radiosity/radiosity_system.hpp"

namespace sr {

/// A patch without its form factors.
struct GreyPatch {
    double reflectance, emission, area = 1;
};

[[nodiscard]] constexpr DoubleSpectrum grey(double value) {
    return {value, value, value};
}

/// The system of patches with factor(i, j).
template <class Factor>
[[nodiscard]] RadiositySystem grey_system(const std::vector<GreyPatch>& patches, const Factor& factor) {
    RadiositySystem system{FormFactorMatrix(patches.size()), {}, {}, {}};
    for (std::size_t i = 0; i < patches.size(); ++i) {
        system.area.push_back(patches[i].area);
        system.reflectance.push_back(grey(patches[i].reflectance));
        system.emission.push_back(grey(patches[i].emission));
        for (std::size_t j = 0; j < patches.size(); ++j) system.form_factors(i, j) = factor(i, j);
    }
    return system;
}

/// Two infinite parallel plates: each sees nothing but the other.
[[nodiscard]] inline RadiositySystem two_plates(GreyPatch first, GreyPatch second) {
    return grey_system({first, second}, [](std::size_t i, std::size_t j) { return i == j ? 0 : 1; });
}

/// Two infinite strips of one width that meet at a right angle, and black surroundings.
[[nodiscard]] inline RadiositySystem corner_of_strips(GreyPatch first, GreyPatch second) {
    const double factor = 1 - std::sqrt(0.5);
    return grey_system({first, second}, [=](std::size_t i, std::size_t j) { return i == j ? 0 : factor; });
}

/// A sphere and the inside of a larger one about the same centre, which sees itself.
[[nodiscard]] inline RadiositySystem concentric_spheres(double ratio, GreyPatch inner, GreyPatch outer) {
    inner.area              = 1;
    outer.area              = square(ratio);
    const double inner_seen = 1 / outer.area;
    return grey_system({inner, outer}, [=](std::size_t i, std::size_t j) {
        if (i == 0) return j == 0 ? 0.0 : 1.0;
        return j == 0 ? inner_seen : 1 - inner_seen;
    });
}

/// The inside of a sphere in pieces: from any of its points, each looks as large as its share of the area.
[[nodiscard]] inline RadiositySystem inside_of_a_sphere(const std::vector<GreyPatch>& pieces) {
    double area = 0;
    for (const auto& piece : pieces) area += piece.area;
    return grey_system(pieces, [&](std::size_t, std::size_t j) { return pieces[j].area / area; });
}

/// The faces of a unit cube: -x, x, -y, y, -z, z.
/// @pre six faces
[[nodiscard]] inline RadiositySystem cube_of_faces(const std::vector<GreyPatch>& faces) {
    const double opposed = opposed_rectangles(1, 1, 1), adjacent = perpendicular_rectangles(1, 1, 1);
    return grey_system(faces, [=](std::size_t i, std::size_t j) {
        if (i == j) return 0.0;
        return i / 2 == j / 2 ? opposed : adjacent;
    });
}

}  // namespace sr
