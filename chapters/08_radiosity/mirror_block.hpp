#pragma once
/// @file mirror_block.hpp
/// Section 8.9: the Cornell box with a mirror in it, as radiosity can paint it and as it looks.

#include <cstddef>
#include <cstdint>
#include <iterator>

#include "cornell_views.hpp"
#include "known_systems.hpp"
#include "material/reflect.hpp"
#include "math/frame.hpp"

namespace sr {

/// Which of the box's polygons are the short block, counted from the last one.
[[nodiscard]] inline bool is_short_block(std::uint32_t polygon, std::size_t polygons) {
    for (std::size_t k = std::size(parts_of_the_box); k-- > 0; polygons -= parts_of_the_box[k].polygons)
        if (parts_of_the_box[k].name == "short block")
            return polygon < polygons && polygon + parts_of_the_box[k].polygons >= polygons;
    return false;
}

inline constexpr double mirrored = 0.9;  ///< the share of the light that the block reflects, however it does

/// The box, its short block painted in the grey that reflects as much as a mirror would.
[[nodiscard]] inline SolvedScene box_with_painted_block(double size, int threads) {
    const Scene box      = cornell_box();
    auto        polygons = polygons_of(box);
    for (std::uint32_t i = 0; i < polygons.size(); ++i)
        if (is_short_block(i, polygons.size())) polygons[i].reflectance = grey(mirrored);
    return solve_patches(cut(polygons, size), box.mesh, threads);
}

/// What an eye takes for the radiosity of a patch: its own, and of the block, where that is a mirror, that of what is
/// seen in it. The block is convex, and so never seen in itself. Refers to all that it is given.
[[nodiscard]] inline RadiosityAt with_mirror(const SolvedScene& box, const PatchView& view,
                                             const RadiosityAt& own, const Vector3<double>& eye) {
    return [&, eye, polygons = box.patches.polygon.back() + 1](const SeenPatch& seen) {
        if (!is_short_block(box.patches.polygon[seen.patch], polygons)) return own(seen);
        const Patch& patch = box.patches.shapes[seen.patch];
        const auto   frame = frame_around(patch.normal());
        const auto   r     = frame.to_world(reflect(frame.to_local(eye - seen.position)));
        const auto   there = view.seen(leave(patch.surface_point(seen.position), r));
        return there ? mirrored * own(*there) : DoubleSpectrum{};
    };
}

/// What is wrong with grey paint, in green.
struct PaintedWrong {
    double lamp;  ///< radiance of the lamp's image over that of the paint which is there instead
    double
        rest;  ///< radiance of the paint beside that image over that of what stands in the mirror, in the mean
};

/// @param there  the picture of the mirror; where both are the same there is none
[[nodiscard]] inline PaintedWrong painted_wrong(const Image<Spectrum>& painted,
                                                const Image<Spectrum>& there) {
    constexpr float lamp = 5;  // [W/(m^2 sr)] and more has nothing else
    double          sums[2][2]{};
    for (std::size_t i = 0; i < there.pixels().size(); ++i) {
        const Spectrum &a = painted.pixels()[i], &b = there.pixels()[i];
        if (a == b) continue;
        sums[b.g > lamp][0] += double(a.g);
        sums[b.g > lamp][1] += double(b.g);
    }
    return {sums[1][1] / sums[1][0], sums[0][0] / sums[0][1]};
}

/// Two pictures, and how wrong the first of them is.
inline void show_mirror_block(course::Chapter& chapter) {
    const int       threads = chapter.options().threads;
    const auto      box     = box_with_painted_block(90, threads);
    const PatchView view(box.patches);
    const auto      own    = interpolated_radiosity(box.patches, box.at_vertices);
    const auto      camera = [](int side) {
        return camera_towards({20, 480, 10}, {220, 130, 200}, {0, 1, 0}, 0.026, side);
    };
    const auto mirror = with_mirror(box, view, own, camera(1).position);
    const auto look   = [&](const RadiosityAt& radiosity, int side, int rays, const RowLoop& loop) {
        return picture(view, camera(side), radiosity, rays, loop);
    };
    course::Progress progress("looking at the mirror", 2 * steps_of_loop);
    const RowLoop    loop = told_to(progress, threads);
    const int        side = chapter.options().size;
    chapter.render("block_painted", "What radiosity makes of a mirror", "Grey that reflects as much.",
                   twice_as_bright(look(own, side, 3, loop)));
    chapter.render("block_mirror", "Rays that end in the solution",
                   "The same solution; the block is looked into.",
                   twice_as_bright(look(mirror, side, 3, loop)));
    const auto wrong = painted_wrong(look(own, 100, 1, {threads}), look(mirror, 100, 1, {threads}));
    chapter.claim("8.9 the lamp in the mirror over the grey that is painted there", {46, wrong.lamp, 0.5});
    chapter.claim("8.9 beside it, the grey over what stands in the mirror", {3.6, wrong.rest, 0.05});
}

}  // namespace sr
