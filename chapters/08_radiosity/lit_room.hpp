#pragma once
/// @file lit_room.hpp
/// A room that all solvers can be tried on: the inside of a unit cube of one colour, lit from its ceiling.

#include <cmath>
#include <vector>

#include "inside_of_a_cube.hpp"
#include "known_systems.hpp"
#include "math/square.hpp"
#include "radiosity/form_factors.hpp"
#include "radiosity/patch_system.hpp"

namespace sr {

/// Each face cut n x n; what lies near the middle of the ceiling shines with a radiosity of 1.
[[nodiscard]] inline RadiositySystem lit_room(int n, double reflectance, int threads) {
    Patches patches = cut(inside_of_a_cube(), 1.0 / n);
    for (std::size_t i = 0; i < patches.size(); ++i) {
        const auto c           = patches.shapes[i].centre();
        const bool shines      = c.z > 0.99 && std::abs(c.x - 0.5) < 0.3 && std::abs(c.y - 0.5) < 0.3;
        patches.reflectance[i] = grey(reflectance);
        patches.emission[i]    = grey(shines ? 1 : 0);
    }
    return system_of(patches, form_factors(patches, Visibility(mesh_of(patches).mesh), {}, {threads}));
}

/// The same room in another grey.
[[nodiscard]] inline RadiositySystem painted(RadiositySystem room, double reflectance) {
    for (auto& rho : room.reflectance) rho = grey(reflectance);
    return room;
}

/// Root of the mean square by area, in the first primary, as a share of that of `whole` [1].
[[nodiscard]] inline double relative_rms(const RadiositySystem& system, const Radiosities& values,
                                         const Radiosities& whole) {
    double part = 0, all = 0;
    for (std::size_t i = 0; i < whole.size(); ++i) {
        part += system.area[i] * square(values[i].r);
        all += system.area[i] * square(whole[i].r);
    }
    return std::sqrt(part / all);
}

/// How wrong radiosities are.
[[nodiscard]] inline double relative_error(const RadiositySystem& system, const Radiosities& found,
                                           const Radiosities& exact) {
    Radiosities wrong(exact.size());
    for (std::size_t i = 0; i < exact.size(); ++i) wrong[i] = found[i] - exact[i];
    return relative_rms(system, wrong, exact);
}

}  // namespace sr
