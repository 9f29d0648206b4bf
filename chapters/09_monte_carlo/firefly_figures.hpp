#pragma once
/// @file firefly_figures.hpp
/// Section 9.10: a small lamp, by directions that do not know of it, clamped, and by its cone.

#include <algorithm>
#include <string>
#include <tuple>

#include "course/claims.hpp"
#include "small_lamp.hpp"

namespace sr {

inline void render_small_lamp(course::Chapter& chapter) {
    const int           size = std::max(chapter.options().size / 2, 16);
    const SmallLampRoom room;
    for (const auto& [name, title, way] :
         {std::tuple{"fireflies", "A small lamp, by the cosine", LampSampling::cosine},
          {"fireflies_clamped", "Clamped at 10 times the mean", LampSampling::clamped},
          {"fireflies_cone", "By the lamp's cone", LampSampling::cone}})
        chapter.render(name, title, "64 samples in each pixel.",
                       room.picture(size, 64, way, chapter.options().threads));
}

/// The table: a ball of radius 0.05 at the distance 2, straight above.
inline void claim_rare_hits(course::Chapter& chapter) {
    const course::Claims claim{chapter, "9.10"};
    const double         sine = 0.05 / 2;
    const RareHits       hits{sine * sine};
    for (const auto& [n, deviation, black, median, digit] : {std::tuple{64, 5.0, 96.0, 0.0, 0.05},
                                                             {1024, 1.25, 53.0, 0.0, 0.005},
                                                             {16'384, 0.31, 0.004, 0.98, 0.005}}) {
        const auto of = std::to_string(n) + " samples: ";
        claim(of + "deviation over the mean", deviation, hits.deviation(n), digit);
        claim(of + "black pixels [%]", black, 100 * hits.black(n), n > 10'000 ? 0.0005 : 0.5);
        claim(of + "median over the mean", median, hits.median(n), 0.005);
    }
    claim("a lamp of radius 0.05: share of the projected hemisphere", 6.25e-4, hits.q, 5e-7);
    const auto seen  = look_for_lamp(sine, 64, 4096, chapter.options().threads);
    const auto black = std::ranges::count(seen, 0.0);
    claim("64 samples: black pixels of 4096 [%]", 96.2, 100 * double(black) / 4096, 0.05);
    claim("clamped at 10 times the mean: what is left [%]", 0.625, 100 * 10 * hits.q, 5e-4);
}

}  // namespace sr
