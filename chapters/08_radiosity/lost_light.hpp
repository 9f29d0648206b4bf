#pragma once
/// @file lost_light.hpp
/// Where the light of an open scene goes.

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <vector>

#include "matrix_picture.hpp"
#include "radiosity/residual.hpp"

namespace sr {

/// Of the light that the lamp emits, the share that each part of the box absorbs, and last that which leaves it: of a
/// patch's light, what its row of form factors lacks of 1.
[[nodiscard]] inline std::vector<double> where_light_goes(const SolvedScene& box) {
    const auto          first  = first_patches(box.patches);
    const auto&         system = box.system;
    const auto          total  = [](const DoubleSpectrum& s) { return s.r + s.g + s.b; };
    std::vector<double> gone(first.size());
    double              emitted = 0;
    for (std::size_t part = 0; part + 1 < first.size(); ++part)
        for (std::size_t i = first[part]; i < first[part + 1]; ++i) {
            const DoubleSpectrum kept     = grey(1) - system.reflectance[i];
            const DoubleSpectrum received = irradiance(system.form_factors, box.radiosities, i);
            gone[part] += system.area[i] * total(kept * received);
            gone.back() += system.area[i] * total(box.radiosities[i]) * (1 - system.form_factors.row_sum(i));
            emitted += system.area[i] * total(system.emission[i]);
        }
    for (double& share : gone) share /= emitted;
    return gone;
}

/// A bar for each part.
inline void draw_lost_light(course::Diagram diagram, const std::vector<double>& gone) {
    using course::Anchor, course::Ink, course::Weight;
    for (std::size_t part = 0; part < gone.size(); ++part) {
        const bool   out = part + 1 == gone.size();
        const double y = -0.75 * double(part), length = 40 * gone[part];
        diagram.label({-0.2, y}, out ? "out" : std::string(parts_of_the_box[part].name), Anchor::right);
        diagram.polygon({{0, y - 0.25}, {length, y - 0.25}, {length, y + 0.25}, {0, y + 0.25}},
                        {out ? Ink::vermilion : Ink::blue, Weight::thin}, 0.5);
        diagram.label({length + 0.2, y}, fmt::format("{:.0f} %", 100 * gone[part]));
    }
}

inline void show_lost_light(course::Chapter& chapter) {
    // One row of these has 1.0134, a patch at a block's foot; with 256 rays a pair instead of 16 it has 1.0001.
    constexpr double noise   = 0.005;
    const auto       patches = cut(polygons_with_aligned_floor(), 150);
    const auto       box     = solve_patches(patches, cornell_box().mesh, chapter.options().threads, noise);
    const auto       gone    = where_light_goes(box);
    auto             diagram = chapter.diagram("lost_light", "What becomes of the lamp's light");
    draw_lost_light(diagram, gone);
    diagram.caption("Absorbed, and lost through the open side, of what the lamp of the Cornell box emits.");
    double sum = 0;
    for (const double share : gone) sum += share;
    chapter.claim("8.9 what is absorbed and what leaves the box, together [%]", {100, 100 * sum, 0.01});
    chapter.claim("8.9 of the lamp's light, there leaves the box [%]", {31, 100 * gone.back(), 0.5});
}

}  // namespace sr
