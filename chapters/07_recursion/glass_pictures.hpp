#pragma once
/// @file glass_pictures.hpp
/// Figure 7.15: a ball of glass at sizes for which an epsilon is too large or too small, and how many pixels that
/// costs.

#include <fmt/format.h>

#include <tuple>

#include "course/chapter.hpp"
#include "glass_ball.hpp"

namespace sr {

/// Wrong pixels of 100 x 100, whatever the pictures' size [%]: those that differ from the picture of radius 1.
template <class Depart>
[[nodiscard]] double wrong_pixels(double radius, int threads, const Depart& depart) {
    const auto picture = [&](double r, const auto& leave_by) {
        return picture_of_glass_ball(r, 100, {.samples = 1}, {.threads = threads}, leave_by);
    };
    return differing(picture(radius, depart), picture(1, leave_by_error_bound)) / 100.0;
}

inline void show_glass_balls(course::Chapter& chapter) {
    const auto&      options = chapter.options();
    course::Progress progress("tracing balls of glass", 4 * steps_of_picture);
    const auto       shown = [&](double radius, const auto& depart) {
        const PixelSampling sampling{.samples = options.samples, .seed = options.seed};
        return picture_of_glass_ball(radius, options.size / 2, sampling, told_to(progress, options.threads),
                                           depart);
    };
    chapter.render("glass_bound", "A ball of glass by the error bound",
                   "Radius 1000; all radii give this picture.", shown(1e3, leave_by_error_bound));
    for (const auto& [name, radius, wrong, digit] :
         {std::tuple{"small", 6e-5, 19.0, 1.0}, {"large", 10.0, 0.1, 0.1}, {"larger", 1e3, 37.0, 1.0}}) {
        chapter.render(fmt::format("glass_{}", name), "A ball of glass by a fixed epsilon",
                       fmt::format("Epsilon is 0.0001, the radius {}.", radius),
                       shown(radius, leave_by_fixed_epsilon));
        chapter.claim(fmt::format("7.8 fixed epsilon: wrong pixels at a radius of {} [%]", radius),
                      {wrong, wrong_pixels(radius, options.threads, leave_by_fixed_epsilon), digit / 2});
        chapter.claim(fmt::format("7.8 error bound: wrong pixels at a radius of {} [%]", radius),
                      {0, wrong_pixels(radius, options.threads, leave_by_error_bound), 0});
    }
}

}  // namespace sr
