#pragma once
/// @file plates_and_lamps.hpp
/// A scene after Veach's: plates, dull to smooth, and lamps, small to large. Each plate is tilted so that the eye sees
/// all of the lamps in it.
/// @see Veach, Robust Monte Carlo Methods for Light Transport Simulation (1997), section 9.2

#include <array>
#include <cstddef>
#include <cstdint>

#include "math/square.hpp"
#include "scene/camera.hpp"
#include "scene/small_scenes.hpp"
#include "scene/surfaces.hpp"
#include "transport/image_error.hpp"

namespace sr {

inline constexpr std::array<float, 4>  plate_exponents{30, 300, 3000,
                                                      30'000};  ///< of Phong's lobe, the lowest first
inline constexpr std::array<double, 4> lamp_radii{0.03, 0.1, 0.3, 0.9};  ///< from the left

namespace plates {
inline constexpr Vector3<double> eye{0, 2, 15}, middle_of_lamps{0, 5, 0};

/// A rectangle whose normal lies half way between the eye and the lamps; from the distance 1 it is seen 0.53 wide and
/// 0.09 high.
inline void add_plate(Scene& scene, double z, double slope, std::uint32_t material) {
    const Vector3<double> centre{0, eye.y - slope * (eye.z - z), z};
    const double          distance = length(eye - centre);
    const auto            to_eye   = (eye - centre) / distance;
    const auto            normal   = normalize(to_eye + normalize(middle_of_lamps - centre));
    const Vector3<double> aside    = 0.265 * distance * Vector3<double>{1, 0, 0};
    const auto up = 0.045 * distance / dot(normal, to_eye) * cross(normal, Vector3<double>{1, 0, 0});
    add_quad(scene, {{centre - aside - up, centre + aside - up, centre + aside + up, centre - aside + up}},
             material);
}
}  // namespace plates

/// Plates are of material 0, 1, 2, 3, lamps of 4, 5, 6, 7. All lamps have the same power.
[[nodiscard]] inline Scene plates_and_lamps() {
    Scene scene;
    for (const float exponent : plate_exponents)
        scene.materials.push_back(
            {"plate", LobeSum<float>{{{{0.9F, 0.9F, 0.9F}, Phong<float>(exponent)}}}, {}});
    for (std::uint32_t i = 0; i < 4; ++i) plates::add_plate(scene, 5 - 2.0 * i, 0.40 - 0.115 * i, i);
    for (std::uint32_t i = 0; i < 4; ++i) {
        const double radius = lamp_radii[i];
        scene.materials.push_back(grey(0, float(square(0.9 / radius))));
        scene.balls.push_back(
            {{plates::middle_of_lamps + Vector3<double>{2.4 * i - 3.6, 0, 0}, radius}, 4 + i});
    }
    return scene;
}

/// The same with one lamp, others don't shine.
[[nodiscard]] inline Scene plates_and_lamp(std::size_t lamp) {
    Scene scene = plates_and_lamps();
    for (std::size_t i = 0; i < 4; ++i)
        if (i != lamp) scene.materials[4 + i].emission = {};
    return scene;
}

[[nodiscard]] inline Camera<double> plates_camera(int side) {
    return pinhole_camera<double>(plates::eye, {0, -0.1, -1}, {0, 1, 0}, 1, 0.74, side, side);
}

/// Pixels whose middle shows the plate.
[[nodiscard]] inline PixelMask pixels_of_plate(const Scene& scene, const Camera<double>& camera,
                                               std::uint32_t plate) {
    const Surfaces<float> surfaces(scene);
    const auto            rounded = convert<float>(camera);
    PixelMask             mask(camera.width, camera.height);
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            const auto hit = surfaces.nearest(rounded.ray_through_pixel(x, y));
            mask(x, y)     = hit && hit->material == plate ? 1 : 0;
        }
    return mask;
}

}  // namespace sr
