#pragma once
/// @file to_error.hpp
/// A picture that is rendered until its error is what was asked for.
///
///     const SampledImage image =
///         traced_to_error<SobolPoint>(camera, mask, {.error = 0.05}, pass, loop, radiance, goes_on);

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "sampling/hash.hpp"
#include "transport/image_error.hpp"
#include "transport/sampled_image.hpp"

namespace sr {

/// What is asked for, and how it is reached.
struct ErrorGoal {
    double error  = 0.05;  ///< relative standard error of the pixels that count, above 0
    int    pilot  = 4;     ///< passes that say where more are needed and then are forgotten, 2 or more
    double evenly = 0.25;  ///< the share of all further passes that each pixel gets alike, 0 to 1
};

/// Which part of the passes each pixel gets; 1 on average. By (9.26) it is in proportion to the standard deviation of a
/// pass, as the pilot's passes of the pixels around say, two to each side; and the pilot may have missed what is rare,
/// so that a share is given to all alike. Pixels that don't count get what they would on average.
/// @pre the pilot has two passes or more
[[nodiscard]] Image<double> pass_shares(const SampledImage& pilot, const PixelMask& mask, double evenly);

/// Whether there is a pixel (x, y) of which that is so.
[[nodiscard]] bool any_pixel(const PixelMask& image, const std::function<bool(int x, int y)>& test);

/// Passes per pixel on average to go on to, from `passes` of them which brought an error: as many as the law n^-1/2
/// says, but no more than half of them at a time, because that error is an estimate as well.
[[nodiscard]] inline double next_passes(double passes, double error, double wanted) {
    const double factor = (error / wanted) * (error / wanted);
    return passes *
           (factor < 1.5 ? std::max(factor, 1.02) : 1.5);  // also of NaN: a picture that is black so far
}

/// Renders pass by pass until the error is at most what is asked for. Which pixels get more, the pilot decides;
/// that the picture is done, all of its pixels together: no sample decides on its own pixel.
/// @param mask      which pixels count
/// @param radiance  (Ray<float>, P&) -> Spectrum
/// @param goes_on   (const SampledImage&) -> bool, asked after each pass, those of the pilot too; if not, what is there
///                  is the picture: the pilot while there are no two passes of each pixel
/// @throws std::runtime_error if no light arrives in the pixels that count; BadSample
template <SamplePoint P, class Radiance, class GoesOn>
[[nodiscard]] SampledImage traced_to_error(const Camera<float>& camera, const PixelMask& mask,
                                           const ErrorGoal& goal, const PassOptions& pass,
                                           const TileLoop& loop, const Radiance& radiance,
                                           const GoesOn& goes_on) {
    SampledImage pilot(camera, {hash(pass.seed, 1), pass.samples, pass.filter});
    for (int i = 0; i < goal.pilot; ++i) {
        pilot.add_pass<P>(loop, radiance);
        if (!goes_on(pilot)) return pilot;
    }
    if (std::isnan(pilot.relative_error(mask)))
        throw std::runtime_error("no light arrives in the picture; must come from a lamp to what is seen");
    const auto   shares = pass_shares(pilot, mask, goal.evenly);
    SampledImage image(camera, pass);
    for (double passes = 2;; passes = next_passes(passes, image.relative_error(mask), goal.error)) {
        const auto lacks = [&](int x, int y) {
            return double(image.passes(x, y)) < std::max(2.0, shares(x, y) * passes);
        };
        while (any_pixel(mask, lacks)) {
            image.add_pass<P>(loop, radiance, lacks);
            if (!goes_on(image)) return std::isfinite(image.relative_error(mask)) ? image : pilot;
        }
        if (image.relative_error(mask) <= goal.error) return image;
    }
}

}  // namespace sr
