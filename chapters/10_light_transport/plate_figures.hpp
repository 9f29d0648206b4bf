#pragma once
/// @file plate_figures.hpp
/// Section 10.3: the plates by chance, by asking, and by both.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>

#include "course/claims.hpp"
#include "light_split.hpp"
#include "math/extremes.hpp"
#include "math/square.hpp"
#include "plate_errors.hpp"

namespace sr {

inline void render_plates(course::Chapter& chapter) {
    const int        side = std::max(chapter.options().size, 32);
    course::Progress progress("looking at plates", 3 * 1000);
    const TileLoop   loop{.threads = chapter.options().threads, .on_tile = [&](int done, int of) {
                            progress.tick(course::steps_of_part(1000, done, of));
                        }};
    for (const auto& [name, title, strategy] :
         {std::tuple{"plates_bsdf", "Four plates, four lamps: by chance", Strategy::bsdf},
          {"plates_light", "By asking the lamps", Strategy::light},
          {"plates_power", "By both, with the power heuristic", Strategy::power}})
        chapter.render(name, title, "16 paths in each pixel.",
                       traced<RandomPoint>(plates_and_lamps(), plates_camera(side),
                                           {.strategy = strategy, .bounces = 1}, {.samples = 16}, loop)
                           .mean());
}

/// Who found the light: blue by asking, orange by chance.
inline void render_light_split(course::Chapter& chapter) {
    constexpr Spectrum blue{0.05F, 0.35F, 1}, orange{1, 0.35F, 0.02F};
    const int          side = std::max(chapter.options().size, 32);
    const LightSplit   split(plates_and_lamps());
    SampledImage       image(convert<float>(plates_camera(side)), {.samples = 64});
    image.add_pass<RandomPoint>({.threads = chapter.options().threads},
                                [&](const Ray<float>& ray, RandomPoint& point) {
                                    const auto [asked, met] = split.parts(ray, point);
                                    return mean(asked) * blue + mean(met) * orange;
                                });
    auto film = image.mean();
    for (Spectrum& L : film.pixels()) L = L / (1 + largest(L));  // so that what is bright keeps its hue
    chapter.render("plates_weights", "Who found the light",
                   "Blue is light that lamps were asked for, orange light that was met by chance.", film);
}

/// The errors of three strategies, and what is seen by the best of them.
struct PlateErrors {
    std::array<std::array<std::array<Estimate, 4>, 4>, 3> of;  ///< [BSDF, light, power][plate][lamp]
    PlateCells                                            power;

    explicit PlateErrors(int threads) {
        course::Progress progress("measuring lamps in plates", 3 * 4);
        const auto cells_by = [&](Strategy strategy) { return plate_cells(strategy, threads, progress); };
        power               = cells_by(Strategy::power);
        const std::array cells{cells_by(Strategy::bsdf), cells_by(Strategy::light), power};
        for (std::size_t way = 0; way < 3; ++way)
            for (std::size_t plate = 0; plate < 4; ++plate)
                for (std::size_t lamp = 0; lamp < 4; ++lamp)
                    of[way][plate][lamp] =
                        error_of(cells[way][plate][lamp], power[plate][lamp].radiance.mean());
    }
};

/// Two digits, more or less.
[[nodiscard]] inline std::string short_number(double x) {
    return fmt::format("{:.{}f}", x, x >= 10 ? 0 : x >= 1 ? 1 : 2);
}

/// Tables of errors, darker where they are larger.
inline void draw_plate_errors(course::Chapter& chapter, const PlateErrors& errors) {
    using course::Anchor, course::Ink;
    constexpr double width = 1.3, block = 4 * width + 0.5;  // of a cell, and from one table to the next
    auto             diagram = chapter.diagram("plate_errors", "Relative RMSE of one path a pixel");
    const std::array names{"by chance", "by asking", "by both"};
    const std::array inks{Ink::vermilion, Ink::blue, Ink::green};
    for (std::size_t way = 0; way < 3; ++way) {
        const double left = block * double(way);
        diagram.label({left + 2 * width, 4.5}, names[way], Anchor::centre, inks[way]);
        for (std::size_t lamp = 0; lamp < 4; ++lamp) {
            const double x = left + width * double(lamp);
            for (std::size_t plate = 0; plate < 4; ++plate) {
                const double y = double(plate), error = errors.of[way][plate][lamp].value;
                const double share = std::log10(error / 0.2) / std::log10(150 / 0.2);
                diagram.polygon({{x, y}, {x + width, y}, {x + width, y + 1}, {x, y + 1}},
                                {inks[way], course::Weight::thin}, std::clamp(0.7 * share, 0.0, 0.7));
                diagram.label({x + width / 2, y + 0.5}, short_number(error), Anchor::centre);
            }
            diagram.label({x + width / 2, -0.4}, fmt::format("{}", lamp_radii[lamp]), Anchor::centre);
        }
        diagram.label({left + 2 * width, -1.1}, "radius of the lamp", Anchor::centre);
    }
    for (std::size_t plate = 0; plate < 4; ++plate)
        diagram.label({-0.2, double(plate) + 0.5}, fmt::format("{}", plate_exponents[plate]), Anchor::right);
    diagram.label({-0.2, 4.5}, "exponent", Anchor::right);
    diagram.caption("Plates from dull, below, to smooth, above; a cell is dark where the error is large.");
}

/// To 5 %.
[[nodiscard]] inline bool is_known(const Estimate& error) {
    return error.error <= 0.05 * error.value;
}

/// What the text says of them; tolerances are four standard errors.
inline void claim_plate_errors(course::Chapter& chapter, const PlateErrors& errors) {
    const course::Claims claim{chapter, "10.3"};
    const auto           error = [&](const char* of, double printed, std::size_t way, std::size_t plate,
                           std::size_t lamp) {
        const Estimate seen = errors.of[way][plate][lamp];
        claim(std::string(of) + ": relative RMSE", printed, seen.value, 4 * seen.error);
    };
    error("dull plate, large lamp, by chance", 4.5, 0, 0, 3);
    error("dull plate, large lamp, by asking", 0.49, 1, 0, 3);
    error("dull plate, large lamp, by both", 0.49, 2, 0, 3);
    error("smooth plate, large lamp, by chance", 1.09, 0, 3, 3);
    error("smooth plate, large lamp, by both", 1.10, 2, 3, 3);
    error("third plate, large lamp, by chance", 1.2, 0, 2, 3);
    error("third plate, large lamp, by asking", 12, 1, 2, 3);
    error("third plate, large lamp, by both", 1.2, 2, 2, 3);
    error("second plate, large lamp, by chance", 1.96, 0, 1, 3);
    error("second plate, large lamp, by asking", 2.45, 1, 1, 3);
    error("second plate, large lamp, by both", 1.49, 2, 1, 3);
    double worst = 0;
    for (std::size_t plate = 0; plate < 4; ++plate)
        for (std::size_t lamp = 0; lamp < 4; ++lamp) {
            const Estimate chance = errors.of[0][plate][lamp], asking = errors.of[1][plate][lamp],
                           both   = errors.of[2][plate][lamp];
            const Estimate better = chance.value < asking.value ? chance : asking;
            if (is_known(better) && is_known(both)) worst = max_or_nan(worst, both.value / better.value);
        }
    // 1.1, and four standard errors of a ratio of two that are known to 5 %
    chapter.claim_at_most("10.3 by both, against the better way for each plate and lamp: ratio of the errors",
                          worst, 1.4);
}

/// The light in the second plate as it is split, over that of the path tracer; tolerances are four standard errors.
inline void claim_light_split(course::Chapter& chapter, const PlateErrors& errors) {
    constexpr std::size_t plate = 1;
    const auto            view  = plates_camera(plates_side);
    const auto            mask  = pixels_of_plate(plates_and_lamps(), view, plate);
    double                whole = 0, variance = 0;
    for (const PlateCell& cell : errors.power[plate]) {
        whole += cell.radiance.mean();
        variance += square(cell.radiance.standard_error());
    }
    struct Seen {
        Running both, met;
    };
    const auto seen = [&](double mistake) {
        const LightSplit split(plates_and_lamps(), mistake);
        Seen             over_whole;
        for (std::uint32_t i = 0; i < 1U << 19; ++i) {
            RandomPoint point(SampleId{.seed = 71, .index = i});
            const Vec2  at = float(plates_side) * point.pair<float>();
            if (mask(int(at.x), int(at.y)) == 0) continue;
            const auto [asked, met] = split.parts(convert<float>(view).ray(at), point);
            over_whole.both.add(double(mean(asked + met)) / whole);
            over_whole.met.add(double(mean(met)) / whole);
        }
        return over_whole;
    };
    const auto tolerance = [&](const Running& of) {
        return 4 * std::hypot(of.standard_error(), std::sqrt(variance) / whole);
    };
    const course::Claims claim{chapter, "10.3"};
    const auto           right = seen(1), wrong = seen(4);
    claim("second plate: both parts over the whole", 1, right.both.mean(), tolerance(right.both));
    claim("second plate: share that was met [%]", 26, 100 * right.met.mean(), 100 * tolerance(right.met));
    claim("second plate, by four times the density: over the whole", 0.87, wrong.both.mean(),
          tolerance(wrong.both));
}

}  // namespace sr
