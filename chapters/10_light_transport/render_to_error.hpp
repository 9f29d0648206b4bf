#pragma once
/// @file render_to_error.hpp
/// Section 10.10: a picture that is done when its error is what was asked for, or when Ctrl-C says so.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "box_of_balls.hpp"
#include "course/chapter.hpp"
#include "course/interruptible.hpp"
#include "error_colours.hpp"
#include "math/square.hpp"
#include "sampling/sobol_point.hpp"
#include "scene/scene_view.hpp"
#include "stated_error.hpp"
#include "transport/path_tracer.hpp"
#include "transport/to_error.hpp"
#include "transport/traced.hpp"

namespace sr {

/// @throws std::runtime_error if 16 paths in each pixel bring no light from what is seen, lamps left out
inline void check_light_arrives(const SceneView& view, const std::string& file, int threads) {
    const auto seen = traced(view.scene, view.camera, {}, {.seed = 1101}, {.threads = threads});
    if (radiance_of(seen.mean(), without_emitters(view.scene, view.camera)) > 0) return;
    throw std::runtime_error(fmt::format(
        "{}: no light arrives at what is seen; lamps must light what faces +z, whence it is seen, a "
        "little from above and from the right; y is up",
        file));
}

/// The scene of --scene, lit by its own lamps.
/// @throws std::runtime_error if it has none, or as check_light_arrives and view_of_file
[[nodiscard]] inline std::optional<SceneView> scene_with_lamps(course::Chapter& chapter) {
    const auto& options = chapter.options();
    if (!options.scene) return std::nullopt;
    auto view =
        view_of_file(*options.scene, options.size, [&](std::string_view line) { chapter.note(line); });
    const auto file   = options.scene->filename().string();
    const auto shines = [&](auto material) { return view.scene.materials[material].emission != Spectrum{}; };
    if (std::ranges::none_of(view.scene.material_of_face, shines))
        throw std::runtime_error(
            fmt::format("{}: nothing shines; must have faces of a material that does, such as Ke 10 10 10 in "
                        "its .mtl file",
                        file));
    check_light_arrives(view, file, options.threads);
    return view;
}

/// The line that tells how far the picture is: by (10.29) the error falls with the root of the passes, so that the part
/// (asked / error)^2 of them is done.
class ErrorProgress {
public:
    explicit ErrorProgress(double asked) : asked_{asked} {}

    void tell(double error) {
        const double part = square(asked_ / error);
        if (!(part * steps > shown_)) return;
        const int now = int(std::min(part, 1.0) * steps);
        line_.tick(now - shown_);
        shown_ = now;
    }

private:
    static constexpr int steps = 1000;
    double               asked_;
    course::Progress     line_{"rendering to the error", steps};
    int                  shown_ = 0;
};

/// The picture's standard errors over its mean.
[[nodiscard]] inline Image<float> relative_errors(const SampledImage& image, const PixelMask& mask) {
    const double radiance = radiance_of(image.mean(), mask);
    auto         errors   = image.standard_errors();
    for (float& error : errors.pixels()) error = float(double(error) / radiance);
    return errors;
}

/// Each pixel's number of samples over that of all on average.
[[nodiscard]] inline Image<float> relative_samples(const SampledImage& image, int width, int height) {
    Image<float> samples(width, height);
    double       sum = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) sum += double(samples(x, y) = float(image.passes(x, y)));
    for (float& of : samples.pixels()) of = float(double(of) * width * height / sum);
    return samples;
}

/// The lamps of a file may be of any strength: in its picture, what does not shine is 0.25 on average, unless it is
/// black.
[[nodiscard]] inline Image<Spectrum> exposed(Image<Spectrum> film, const PixelMask& mask) {
    const double radiance = radiance_of(film, mask);
    const auto   scale    = float(radiance > 0 ? 0.25 / radiance : 1);
    for (auto& L : film.pixels()) L = scale * L;
    return film;
}

/// Writes the picture, what it says of its error, and where its samples went.
inline void render_with_error(course::Chapter& chapter, const SampledImage& image, const PixelMask& mask,
                              bool interrupted) {
    const double asked = chapter.options().error, error = image.relative_error(mask);
    const double samples = double(image.samples()) / mask.width() / mask.height();
    const auto   known   = std::isfinite(error) ? fmt::format("{:.2g} of the mean", error) : "not known yet";
    const auto what = fmt::format("{:.1f} samples a pixel; standard error {}, asked for {}{}", samples, known,
                                  asked, interrupted ? ", interrupted" : "");
    chapter.say(what);
    const auto film = image.mean();
    chapter.render("to_error", "A picture that knows its error", what + ".",
                   chapter.options().scene ? exposed(film, mask) : film);
    if (!std::isfinite(error)) return;
    chapter.render(
        "its_error", "Its standard error",
        "Over its mean: from a tenth of the picture's error to ten times it, equal ratios in equal "
        "steps; notches at half of it, at it, and at twice.",
        map_of_ratios(relative_errors(image, mask), error));
    chapter.render("its_samples", "Its samples",
                   "From a tenth of the mean to ten times it; notches at half of it, at it, and at twice.",
                   map_of_ratios(relative_samples(image, mask.width(), mask.height()), 1));
}

/// The view's picture to the error of --error, or until an interrupt.
[[nodiscard]] inline SampledImage rendered_to_error(const course::Options& options, const SceneView& view,
                                                    const PixelMask&             mask,
                                                    const course::Interruptible& interrupt) {
    const PathTracer tracer(view.scene);
    ErrorProgress    progress(options.error);
    return traced_to_error<SobolPoint>(
        convert<float>(view.camera), mask, {.error = options.error}, {.seed = 1100, .samples = 4},
        {.threads = options.threads},
        [&](const Ray<float>& ray, SobolPoint& point) {
            PathCount count;
            return tracer.radiance(ray, point, count);
        },
        [&](const SampledImage& so_far) {
            progress.tell(so_far.relative_error(mask));
            return !interrupt.asked();
        });
}

/// Renders the person's scene, or the box with balls. The first Ctrl-C ends only the rendering: what there is then is
/// the picture.
/// @throws course::Interrupted after that
inline void render_to_error(course::Chapter& chapter, const std::optional<SceneView>& own,
                            const course::Interruptible& interrupt) {
    const auto view  = own ? *own : box_of_balls(chapter.options().size);
    const auto mask  = without_emitters(view.scene, view.camera);
    const auto image = rendered_to_error(chapter.options(), view, mask, interrupt);
    render_with_error(chapter, image, mask, interrupt.asked());
    if (interrupt.asked()) throw course::Interrupted{};
}

}  // namespace sr
