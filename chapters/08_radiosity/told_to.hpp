#pragma once
/// @file told_to.hpp

#include "course/progress.hpp"
#include "radiosity/rows.hpp"

namespace sr {

/// What a progress counts for a loop: a picture, or another one that takes about as long.
inline constexpr int steps_of_loop = 1000;

/// A loop that tells a progress how far it is.
[[nodiscard]] inline RowLoop told_to(course::Progress& progress, int threads) {
    return {.threads = threads, .on_row = [&](int done, int of) {
                progress.tick(course::steps_of_part(steps_of_loop, done, of));
            }};
}

}  // namespace sr
