#pragma once
/// @file seed_figures.hpp
/// Section 9.10: the same shadow with pixels that are seeded alike, by their number, and by a hash.

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include "course/claims.hpp"
#include "seeds.hpp"

namespace sr {

inline void render_seeds(course::Chapter& chapter) {
    const int size = std::max(chapter.options().size / 2, 16);
    for (const auto& [name, title, seeding] :
         {std::tuple{"seeds_alike", "The same seed in every pixel", Seeding::all_alike},
          {"seeds_by_index", "A simple generator, seeded with the pixel's number", Seeding::by_index},
          {"seeds_hashed", "A hash of the pixel for a seed", Seeding::hashed}})
        chapter.render(name, title, "4 samples in each pixel.",
                       floor_seeded(seeding, size, 4, chapter.options().threads));
}

inline void claim_seeds(course::Chapter& chapter) {
    const course::Claims claim{chapter, "9.10"};
    constexpr int        pixels = 10'000;
    std::vector<double>  by_index, hashed;
    Running              of_image;
    for (int i = 0; i < pixels; ++i) {
        by_index.push_back(IndexSeeded(i).uniform());
        Rng rng{1, i, 0, 0};
        hashed.push_back(rng.uniform<double>());
        Running pixel;
        for (int k = 0; k < 16; ++k) pixel.add(rng.uniform<double>());
        of_image.add(pixel.mean());
    }
    claim("seeded by number: correlation of 10000 neighbours", 1, correlation_of_neighbours(by_index), 5e-7);
    for (const auto& [nth, printed] : {std::pair{2, 0.31}, {3, -0.11}, {4, -0.49}, {5, -0.49}}) {
        std::vector<double> later;
        for (int i = 0; i < pixels; ++i) {
            IndexSeeded generator(i);
            for (int k = 1; k < nth; ++k) (void)generator.uniform();
            later.push_back(generator.uniform());
        }
        const double sign = printed < 0 ? -1 : 1;
        claim(fmt::format("seeded by number: correlation of neighbours, number {}{}", nth,
                          sign < 0 ? ", below 0 by" : ""),
              sign * printed, sign * correlation_of_neighbours(later), 5e-3);
    }
    claim("16807 times the seed: smallest first number", 0.097, *std::ranges::min_element(by_index), 5e-4);
    claim("largest", 0.175, *std::ranges::max_element(by_index), 5e-4);
    claim("hashed: correlation of neighbours, below 0 by", 0.017, -correlation_of_neighbours(hashed), 5e-4);

    Rng     alike{1, 0, 0, 0};
    Running pixel;
    for (int k = 0; k < 16; ++k) pixel.add(alike.uniform<double>());
    claim("the same seed: mean of every pixel", 0.461, pixel.mean(), 5e-4);
    claim("hashed: mean of the image", 0.5013, of_image.mean(), 5e-5);
    claim("hashed: its standard error", 0.0007, of_image.standard_error(), 5e-5);
}

}  // namespace sr
