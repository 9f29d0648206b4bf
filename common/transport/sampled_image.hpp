#pragma once
/// @file sampled_image.hpp
/// A picture that gets better with each pass, and knows how good it is.
///
///     SampledImage image(camera, {.seed = 1, .samples = 16});
///     while (image.relative_error() > 0.05) image.add_pass<SobolPoint>(loop, radiance);
///     write(image.mean(), image.samples());

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "image/image.hpp"
#include "radiometry/spectrum.hpp"
#include "sampling/hash.hpp"
#include "sampling/sample_point.hpp"
#include "scene/camera.hpp"
#include "statistics/running.hpp"
#include "transport/image_error.hpp"
#include "transport/pixel_filter.hpp"
#include "transport/render.hpp"
#include "transport/tiles.hpp"

namespace sr {

/// What one pass is.
struct PassOptions {
    std::uint64_t seed = 1;
    std::uint32_t samples =
        16;  ///< of a pixel in a pass, which know of each other; those of different passes don't
    PixelFilter filter = PixelFilter::box;
};

/// Each pixel's mean over passes and, because passes are independent whatever pattern the samples of one have, the
/// mean's standard error.
class SampledImage {
public:
    SampledImage(const Camera<float>& camera, const PassOptions& options)
        : camera_{camera}, options_{options}, pixels_(camera.width, camera.height) {}

    /// @tparam P         the pattern
    /// @param  radiance  (Ray<float>, P&) -> Spectrum
    /// @param  wanted    (x, y) -> whether the pixel gets this pass
    /// @throws BadSample if a sample is negative or not finite; the number of the sample counts over all passes
    template <SamplePoint P, class Radiance, class Wanted>
    void add_pass(const TileLoop& loop, const Radiance& radiance, const Wanted& wanted) {
        for_each_pixel(camera_.width, camera_.height, loop, [&](int x, int y) {
            if (wanted(x, y)) pixels_(x, y).add(sampled<P>(x, y, radiance));
        });
    }
    template <SamplePoint P, class Radiance>
    void add_pass(const TileLoop& loop, const Radiance& radiance) {
        add_pass<P>(loop, radiance, [](int, int) { return true; });
    }

    /// [W/(m^2 sr)], black before the first pass.
    [[nodiscard]] Image<Spectrum> mean() const;
    /// Of the mean of the channels [W/(m^2 sr)], after two passes or more.
    [[nodiscard]] Image<float>    standard_errors() const;
    /// Root mean square of the pixels' standard errors over the mean of all pixels [1]; infinite before the second
    /// pass.
    [[nodiscard]] double          relative_error() const;
    /// Of the pixels that count: NaN if none does, or they are black.
    [[nodiscard]] double          relative_error(const PixelMask& mask) const;
    [[nodiscard]] std::uint64_t   samples() const;  ///< of all pixels
    [[nodiscard]] std::uint64_t   passes(int x, int y) const { return pixels_(x, y).brightness.count(); }

private:
    struct Pixel {
        DoubleSpectrum sum;
        Running        brightness;  ///< of the passes
        void           add(DoubleSpectrum L);
    };

    template <SamplePoint P, class Radiance>
    [[nodiscard]] DoubleSpectrum sampled(int x, int y, const Radiance& radiance) const {
        const auto     pass = pixels_(x, y).brightness.count();
        DoubleSpectrum sum;
        for (std::uint32_t i = 0; i < options_.samples; ++i) {
            P              point(SampleId{hash(options_.seed, pass), x, y, i, options_.samples});
            // more of them lie where the pixel sees more
            const Vec2     at = Vec2{x, y} + sample_filter(options_.filter, point.template pair<float>());
            const Spectrum L  = radiance(camera_.ray(at), point);
            if (!each_in(L, 0, std::numeric_limits<float>::max()))
                throw BadSample(x, y, int(pass * options_.samples + i), L);
            sum = sum + convert<double>(L);
        }
        return sum / double(options_.samples);
    }

    Camera<float> camera_;
    PassOptions   options_;
    Image<Pixel>  pixels_;
};

}  // namespace sr
