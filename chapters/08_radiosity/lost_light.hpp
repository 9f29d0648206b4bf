#pragma once
/// @file lost_light.hpp
/// Where the light of an open scene goes.

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

#include "matrix_picture.hpp"
#include "radiosity/cosine_rays.hpp"
#include "radiosity/residual.hpp"
#include "statistics/running.hpp"

namespace sr {

/// Of each patch's light, the share that meets no other patch's front: what its row of form factors should lack of 1,
/// by side^2 cosine rays, which know nothing of form factors. The same for any number of threads.
[[nodiscard]] inline std::vector<double> leaving_by_rays(const Patches& patches, int side, std::uint64_t seed,
                                                         int threads) {
    const CosineRays    rays(patches);
    std::vector<double> leaving(patches.size(), 1);
    for_each_row(patches.size(), {threads}, [&](std::size_t i) {
        Rng rng{seed, std::int64_t(i), 0, 0};
        for (const double arrives : rays.row(i, side, rng)) leaving[i] -= arrives;
    });
    return leaving;
}

/// Of the light that the lamp emits, the share that each part of the box absorbs, and last that which leaves it.
/// @param leaving  of each patch's light
[[nodiscard]] inline std::vector<double> where_light_goes(const SolvedScene&         box,
                                                          const std::vector<double>& leaving) {
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
            gone.back() += system.area[i] * total(box.radiosities[i]) * leaving[i];
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
        diagram.label({length + 0.2, y},
                      fmt::format("{:.{}f} %", 100 * gone[part], gone[part] < 0.01 ? 1 : 0));
    }
}

/// All shares together, 1 if the form factors are right, by 32^2 rays a patch, eight times anew.
[[nodiscard]] inline Running balance(const SolvedScene& box, int threads) {
    Running sum;
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
        const auto gone = where_light_goes(box, leaving_by_rays(box.patches, 32, seed, threads));
        sum.add(std::accumulate(gone.begin(), gone.end(), 0.0));
    }
    return sum;
}

inline void show_lost_light(course::Chapter& chapter) {
    // One row of these has 1.0134, a patch at a block's foot; with 256 rays a pair instead of 16 it has 1.0001.
    constexpr double noise   = 0.005;
    const int        threads = chapter.options().threads;
    const auto       patches = cut(polygons_with_aligned_floor(), 150);
    const auto       box     = solve_patches(patches, cornell_box().mesh, threads, noise);
    const auto       gone    = where_light_goes(box, leaving_by_rays(patches, 32, 0, threads));
    auto             diagram = chapter.diagram("lost_light", "What becomes of the lamp's light");
    draw_lost_light(diagram, gone);
    diagram.caption(
        "Absorbed, and lost through the open side, of what the lamp of the Cornell box emits; red, green and "
        "blue are added up.");
    const Running sum = balance(box, threads);
    chapter.claim("8.9 what is absorbed and what leaves the box, together [%]", {100, 100 * sum.mean(), 0.5});
    chapter.claim("8.9 its standard error, of rays [%]", {0.2, 100 * sum.standard_error(), 0.05});
    chapter.claim("8.9 of the lamp's light, there leaves the box [%]", {31, 100 * gone.back(), 0.5});
}

}  // namespace sr
