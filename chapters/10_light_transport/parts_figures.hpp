#pragma once
/// @file parts_figures.hpp
/// Section 10.5: the parts of a picture side by side, what each brings, and who finds it.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "box_of_balls.hpp"
#include "course/claims.hpp"
#include "math/extremes.hpp"
#include "parts_of_light.hpp"
#include "picture_grid.hpp"
#include "sampling/random_point.hpp"
#include "sampling/sobol_point.hpp"
#include "statistics/estimate.hpp"
#include "transport/traced.hpp"

namespace sr {

using PartEstimates = std::array<Estimate, parts_of_light.size()>;

/// All parts, and at last their sum.
inline void render_parts(course::Chapter& chapter) {
    const auto&      options = chapter.options();
    const int        side    = std::max(options.size / 2, 16);
    const auto       samples = options.quality == course::Quality::draft ? 16U : 256U;
    course::Progress progress("10.5 light in parts", 1000);
    const TileLoop   loop{options.threads, [&](int done, int of) { progress.tick_part(done, of); }};
    const auto picture = picture_in_parts<SobolPoint>(box_of_balls(side), Strategy::power, 1, samples, loop);
    std::vector<Image<Spectrum>> images(parts_of_light.size() + 1, Image<Spectrum>(side, side));
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            DoubleSpectrum sum;
            for (std::size_t k = 0; k < parts_of_light.size(); ++k) {
                const auto L    = picture(x, y).sum[k] / double(samples);
                images[k](x, y) = convert<float>(L);
                sum             = sum + L;
            }
            images.back()(x, y) = convert<float>(sum);
        }
    }
    chapter.render(
        "parts", "A picture in parts",
        "The lamp, its images, direct light, interreflection; images of both, caustics, all other, and "
        "the sum.",
        grid_of(images, 4));
}

/// The parts add up to what a path brings, to rounding.
inline void claim_sum_of_parts(course::Chapter& chapter) {
    const auto     view = box_of_balls(24);
    const TileLoop loop{chapter.options().threads};
    const auto     parts = picture_in_parts<RandomPoint>(view, Strategy::power, hash(1, 0), 16, loop);
    const auto     whole =
        traced<RandomPoint>(view.scene, view.camera, {}, {.seed = 1, .samples = 16}, loop).mean();
    double most = 0;
    for (std::size_t i = 0; i < whole.pixels().size(); ++i) {
        double sum = 0;
        for (const auto& part : parts.pixels()[i].brightness) sum += part.mean();
        const double all = double(mean(whole.pixels()[i]));
        most             = max_or_nan(most, std::abs(sum - all) / (1 + all));
    }
    chapter.claim_at_most("10.5 parts and whole: largest difference of a pixel [W/(m^2 sr)]", most, 1e-6);
}

/// Of one strategy: each part's share of the picture's light, and the error of one sample of it, relative to the part's
/// mean: root of the mean variance over pixels, of 16 x 16 of them. By eight independent pictures.
struct FoundParts {
    PartEstimates share, error;
};

[[nodiscard]] inline FoundParts find_parts(Strategy strategy, int threads) {
    constexpr std::size_t  n = parts_of_light.size();
    std::array<Running, n> shares, means, variances;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        const auto picture = picture_in_parts<SobolPoint>(box_of_balls(16), strategy, seed, 128, {threads});
        std::array<Running, n> mean, variance;
        double                 all = 0;
        for (const auto& pixel : picture.pixels()) {
            for (std::size_t k = 0; k < n; ++k) {
                mean[k].add(pixel.brightness[k].mean());
                variance[k].add(pixel.brightness[k].variance());
            }
        }
        for (const auto& part : mean) all += part.mean();
        for (std::size_t k = 0; k < n; ++k) {
            shares[k].add(mean[k].mean() / all);
            means[k].add(mean[k].mean());
            variances[k].add(variance[k].mean());
        }
    }
    FoundParts found;
    for (std::size_t k = 0; k < n; ++k) {
        const double error = std::sqrt(variances[k].mean()) / means[k].mean();
        found.share[k]     = {shares[k].mean(), shares[k].standard_error()};
        // half of the variance's relative error, and all of the mean's
        found.error[k] = {error, error * std::hypot(variances[k].standard_error() / variances[k].mean() / 2,
                                                    means[k].standard_error() / means[k].mean())};
    }
    return found;
}

/// What the text says of a part: its share [%], and the errors by each strategy.
struct PrintedPart {
    double                share;
    std::array<double, 4> errors;
    double                digit;  ///< of the last two
};

/// The table of parts, within four standard errors.
inline void claim_parts(course::Chapter& chapter) {
    constexpr std::array strategies{std::pair{"blind", Strategy::blind}, std::pair{"bsdf", Strategy::bsdf},
                                    std::pair{"light", Strategy::light},
                                    std::pair{"balance", Strategy::balance}};
    constexpr std::array<PrintedPart, parts_of_light.size()> printed{{{48, {9.8, 9.8, 9.8, 9.8}, 0.1},
                                                                      {2, {56, 56, 56, 56}, 1},
                                                                      {24, {18, 14, 0.54, 0.56}, 0.01},
                                                                      {12, {21, 15, 1.45, 1.46}, 0.01},
                                                                      {5, {37, 31, 2.5, 2.6}, 0.1},
                                                                      {2, {59, 47, 47, 47}, 1},
                                                                      {7, {34, 29, 21, 21}, 1}}};
    const course::Claims                                     claim{chapter, "10.5"};
    course::Rows table{{"part", "ways", "by", "share [%]", "+-", "error of a sample", "+-"}};
    for (std::size_t i = 0; i < strategies.size(); ++i) {
        const auto& [name, strategy] = strategies[i];
        const auto found             = find_parts(strategy, chapter.options().threads);
        for (std::size_t k = 0; k < parts_of_light.size(); ++k) {
            const auto [part, ways] = parts_of_light[k];
            const auto   share      = percent(found.share[k]);
            const double digit      = i < 2 && k > 0 ? 1 : printed[k].digit;
            table.add({std::string(part), std::string(ways), name, share.value, share.error,
                       found.error[k].value, found.error[k].error});
            claim(fmt::format("{}, by {}: relative error of a sample", part, name), printed[k].errors[i],
                  found.error[k].value, digit / 2 + 4 * found.error[k].error);
            if (strategy == Strategy::balance)
                claim(fmt::format("{}: share of the light [%]", part), printed[k].share, share.value,
                      0.5 + 4 * share.error);
        }
    }
    chapter.say(table);
}

}  // namespace sr
