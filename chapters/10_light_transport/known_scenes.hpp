#pragma once
/// @file known_scenes.hpp
/// Section 10.6: scenes in which the radiance is known, whatever way paths take.

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "geometry/ray.hpp"
#include "math/square.hpp"
#include "path_means.hpp"
#include "scene/small_scenes.hpp"
#include "transport/path_tracer.hpp"

namespace sr {

/// A scene, a ray into it, and the radiance that must come back [W/(m^2 sr)].
struct KnownScene {
    std::string name;
    Scene       scene;
    Ray<float>  ray;
    double      radiance;
};

/// What the path tracer says of it, in green.
[[nodiscard]] inline Running traced_mean(const KnownScene& known, int paths, int threads,
                                         const PathOptions& options = {}) {
    const PathTracer tracer(known.scene, options);
    return path_mean(paths, threads, [&](RandomPoint& point) {
        PathCount count;
        return tracer.radiance(known.ray, point, count).g;
    });
}

/// A convex body in a sky of 1: of all that arrives, it gives back rho.
[[nodiscard]] inline KnownScene ball_in_the_sky() {
    Scene scene      = inside_of_a_ball(0.5F, 0);
    scene.background = {1, 1, 1};
    return {"ball in the sky", scene, {{0.3F, -3, 0.4F}, {0, 1, 0}}, 0.5};
}

/// The inside of a ball that shines by paths of at most so many bounces, equation (10.20).
[[nodiscard]] inline double inside_after(double rho, int bounces) {
    return (1 - std::pow(rho, bounces + 1)) / (1 - rho);
}

[[nodiscard]] inline KnownScene shining_ball() {
    return {"shining ball", inside_of_a_ball(0.5F, 1), {{0.1F, 0.2F, -0.3F}, {0.4F, 1, 0.3F}}, 2};
}

/// Dark and bright walls and a ball before one of them, all of which emit what they absorb: 1 everywhere. What is
/// looked at is the wall behind the ball.
[[nodiscard]] inline KnownScene room_of_ones() {
    Scene scene;
    for (const float rho : {0.0F, 0.1F, 0.8F, 0.6F, 0.1F, 0.0F, 0.8F})
        scene.materials.push_back(grey(rho, 1 - rho));
    add_cube(scene, -1, 1);
    scene.balls = {{Sphere<double>{{0.3, 0.3, 0.2}, 0.6}, 6}};
    return {"room of ones", scene, {{-0.9F, 0.9F, -0.2F}, {1.1F, 0.1F, 0.3F}}, 1};
}

/// A floor of reflectance 1/2, on which a black ball of radius 1 lies under a sky of 1; it is seen flatly, from the
/// side that is away from the ball.
/// @param x  from where the ball touches the floor
[[nodiscard]] inline KnownScene floor_by_a_ball(double x) {
    Scene scene;
    scene.materials  = {grey(0.5F), grey(0)};
    scene.background = {1, 1, 1};
    add_quad(scene, {{{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}}}, 0);
    scene.balls = {{Sphere<double>{{0, 0, 1}, 1}, 1}};
    // (10.21) the ball hides pi (1 / d)^2 (1 / d) of the sky's pi, d^2 = 1 + x^2
    const double hidden = std::pow(1 + x * x, -1.5);
    return {"floor by a ball", scene, {{float(x) + 1, 0, 0.1F}, {-1, 0, -0.1F}}, 0.5 * (1 - hidden)};
}

/// The outer of two concentric balls, of radius 2 and reflectance 0.7, lit by the inner one, of radius 1 and
/// reflectance 0.2: it sees that with a form factor of 1/4, and itself with 3/4.
[[nodiscard]] inline KnownScene ball_in_a_ball() {
    Scene scene;
    scene.materials = {grey(0.2F, 1), grey(0.7F)};
    scene.balls     = {{Sphere<double>{{0, 0, 0}, 1}, 0}, {Sphere<double>{{0, 0, 0}, 2}, 1}};
    return {"ball in a ball",
            scene,
            {{1.5F, 0, 0}, {1, 0.3F, 0.2F}},
            0.7 / 4 / (1 - 0.7 * 3 / 4 - 0.2 * 0.7 / 4)};
}

/// A point light of 1 W/sr in a ball of reflectance rho, halfway between its middle and its wall.
struct LampInABall {
    static constexpr double rho = 0.5, off_centre = 0.5;

    /// By the lamp itself at the angle to the lamp's radius, I cos(theta) / r^2 [W/m^2].
    [[nodiscard]] static double direct(double angle) {
        const double c = std::cos(angle), r = std::sqrt(1 + square(off_centre) - 2 * off_centre * c);
        return (1 - off_centre * c) / (r * r * r);
    }
    /// By all other ways, everywhere the same, (10.22) [W/m^2].
    [[nodiscard]] static constexpr double indirect() { return rho / (1 - rho); }
};

/// @param angle  of the wall's point that is looked at, from the middle [rad]
[[nodiscard]] inline KnownScene lamp_in_a_ball(double angle) {
    Scene scene  = inside_of_a_ball(float(LampInABall::rho), 0);
    scene.lights = {{{0, 0, LampInABall::off_centre}, {1, 1, 1}}};
    return {"lamp in a ball",
            scene,
            {{0, 0, 0}, {float(std::sin(angle)), 0, float(std::cos(angle))}},
            LampInABall::rho / std::numbers::pi * (LampInABall::direct(angle) + LampInABall::indirect())};
}

/// A mirror that shines with 1, from inside: each reflection adds 0.8 of the one before.
[[nodiscard]] inline KnownScene mirror_ball() {
    Scene scene                   = inside_of_a_ball(0, 1);
    scene.materials[0].scattering = LobeSum<float>{{{{0.8F, 0.8F, 0.8F}, Mirror<float>{}}}};
    return {"mirror ball", scene, shining_ball().ray, 5};
}

/// All of the above that are diffuse, one ray each.
[[nodiscard]] inline std::vector<KnownScene> known_scenes() {
    return {ball_in_the_sky(),     shining_ball(),   room_of_ones(),
            floor_by_a_ball(0.75), ball_in_a_ball(), lamp_in_a_ball(1)};
}

}  // namespace sr
