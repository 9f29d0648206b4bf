#pragma once
/// @file cornell_views.hpp
/// The solved Cornell box from anywhere.

#include <fmt/format.h>

#include <string>

#include "cornell_solution.hpp"
#include "radiosity/patch_view.hpp"
#include "told_to.hpp"

namespace sr {

/// A camera inside the box or above it, with the published film and another lens.
[[nodiscard]] inline Camera<double> camera_towards(const Vector3<double>& position,
                                                   const Vector3<double>& target, const Vector3<double>& up,
                                                   double focal_length, int side) {
    return pinhole_camera(position, target - position, up, focal_length, cornell_camera::film_side, side,
                          side);
}

/// From above, through the ceiling, whose back is not seen.
[[nodiscard]] inline Camera<double> camera_above(int side) {
    return camera_towards({278, 1350, 279.6}, {278, 0, 279.6}, {0, 0, 1}, cornell_camera::focal_length, side);
}

/// From the far corner below the ceiling, towards the open side.
[[nodiscard]] inline Camera<double> camera_in_corner(int side) {
    return camera_towards({25, 500, 535}, {400, 60, 120}, {0, 1, 0}, 0.018, side);
}

/// The lamp's light on the walls would be dark next to the lamp: pictures are shown twice as bright.
[[nodiscard]] inline Image<Spectrum> twice_as_bright(Image<Spectrum> film) {
    for (auto& pixel : film.pixels()) pixel = 2 * pixel;
    return film;
}

/// One solution, looked at.
class CornellViews {
public:
    /// @param progress  counts steps_of_loop for a picture
    CornellViews(course::Chapter& chapter, const SolvedScene& box, course::Progress& progress)
        : chapter_{chapter}, box_{box}, progress_{progress}, view_(box.patches) {}

    /// As the vertices' radiosities say.
    [[nodiscard]] Image<Spectrum> smooth(const Camera<double>& camera) const {
        return twice_as_bright(as_bright_as_it_is(camera));
    }

    /// The same for a view in which the lamp is near what it lights: there is too much light to double it.
    [[nodiscard]] Image<Spectrum> as_bright_as_it_is(const Camera<double>& camera) const {
        return look(camera, interpolated_radiosity(box_.patches, box_.at_vertices));
    }

    /// A radiosity for each patch.
    [[nodiscard]] Image<Spectrum> faceted(const Camera<double>& camera,
                                          const Radiosities&    radiosities) const {
        return twice_as_bright(look(camera, constant_radiosity(radiosities)));
    }

private:
    [[nodiscard]] Image<Spectrum> look(const Camera<double>& camera, const RadiosityAt& radiosity) const {
        const auto& options = chapter_.options();
        const int   side    = options.quality == course::Quality::draft ? 2 : 4;
        return picture(view_, camera, radiosity, side, told_to(progress_, options.threads));
    }

    course::Chapter&   chapter_;
    const SolvedScene& box_;
    course::Progress&  progress_;
    PatchView          view_;
};

/// The published picture, and two that cost nothing more than looking.
/// @return how long the first took [s]
inline double look_around(course::Chapter& chapter, const SolvedScene& box) {
    course::Progress   progress("looking at the box", 4 * steps_of_loop);
    const CornellViews views(chapter, box, progress);
    const int          size = chapter.options().size;
    const std::string  mesh = fmt::format("{} patches, shown twice as bright.", box.patches.size());
    Image<Spectrum>    smooth(1, 1);
    const double       seconds = course::seconds_of([&] { smooth = views.smooth(cornell_box_camera(size)); });
    chapter.render("box", "The Cornell box", "Interpolated: " + mesh, smooth);
    chapter.render("box_constant", "The same, a radiosity for each patch", "Constant: " + mesh,
                   views.faceted(cornell_box_camera(size), box.radiosities));
    chapter.render(
        "box_above", "From above, through the ceiling",
        "The same solution, as bright as it is: of faces, only fronts are seen. Black: the open side.",
        views.as_bright_as_it_is(camera_above(size)));
    chapter.render("box_corner", "From the far corner", "The same solution.",
                   views.smooth(camera_in_corner(size)));
    return seconds;
}

inline void render_views(course::Chapter& chapter, const SolvedScene& box) {
    const double seconds = look_around(chapter, box);
    chapter.say(fmt::format("{} patches: form factors and solution {:.2g} s, a view {:.2g} s",
                            box.patches.size(), box.seconds, seconds));
}

/// The solution as it comes along, k steps of Jacobi's method with lambda 1: the light of fewer than k bounces.
inline void render_bounces(course::Chapter& chapter, const SolvedScene& box) {
    course::Progress   progress("looking at its bounces", 5 * steps_of_loop);
    const CornellViews views(chapter, box, progress);
    const auto         light = [&](const Radiosities& radiosities) {
        double sum = 0;
        for (std::size_t i = 0; i < radiosities.size(); ++i) sum += box.system.area[i] * mean(radiosities[i]);
        return sum;
    };
    RelaxedJacobi solver(box.system, 1, chapter.options().threads);
    const double  all = light(box.radiosities), lamp = light(box.system.emission);
    int           steps = 0;
    for (const auto& [k, what, share] : {std::tuple{1, "emitted", 0.0},
                                         {2, "after one bounce", 50.0},
                                         {3, "after two", 74.9},
                                         {4, "after three", 87.0},
                                         {8, "after seven", 99.0}}) {
        for (; steps < k; ++steps) solver.step();
        chapter.render(fmt::format("bounces_{}", k - 1), fmt::format("Light {}", what),
                       fmt::format("{} steps of Jacobi's method.", k),
                       views.faceted(cornell_box_camera(chapter.options().size), solver.radiosities()));
        chapter.claim(fmt::format("8.7 of the reflected light, there {} [%]", what),
                      {share, 100 * (light(solver.radiosities()) - lamp) / (all - lamp), 0.05});
    }
}

}  // namespace sr
