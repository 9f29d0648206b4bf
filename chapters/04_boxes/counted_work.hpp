#pragma once
/// @file counted_work.hpp
/// Section 4.5: what a tree is expected to take, and what lines and a camera's rays do take.

#include "chances.hpp"
#include "geometry/hierarchy.hpp"
#include "math/extremes.hpp"
#include "nodes_per_pixel.hpp"
#include "work.hpp"

namespace sr {

struct CountedWork {
    ExpectedWork expected;
    WorkOfLines  lines;
    Work         pixels;

    /// How far what lines ask all along is from what (4.9) expects [standard errors].
    [[nodiscard]] double off() const {
        return max_or_nan(standard_errors_off(lines.whole.nodes, expected.nodes),
                          standard_errors_off(lines.whole.triangles, expected.triangles));
    }
    /// The largest standard error of a count of nodes, or of triangles.
    [[nodiscard]] double worst_error(Running Work::*of) const {
        double worst = 0;
        for (const Work& work : {lines.whole, lines.nearest, pixels})
            worst = max_or_nan(worst, (work.*of).standard_error());
        return worst;
    }
};

[[nodiscard]] inline CountedWork count_work(const Mesh<float>& mesh, Cut cut, int threads) {
    const auto hierarchy = boxes_of(mesh, cut);
    const auto camera = teapot_view(256, 160);  // whatever the picture's size: these numbers are in the text
    return {expected_work(hierarchy.tree()), work_of_lines(hierarchy, {.lines = 100'000, .threads = threads}),
            work_of_pixels(count_per_pixel(hierarchy, camera, {.threads = threads}))};
}

}  // namespace sr
