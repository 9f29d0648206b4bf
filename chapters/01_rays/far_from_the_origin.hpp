#pragma once
/// @file far_from_the_origin.hpp
/// The chart of section 1.5: what rounding does to a scene and its camera that stand far from the origin.

#include <vector>

#include "course/chapter.hpp"
#include "geometry/hierarchy.hpp"
#include "scenes.hpp"
#include "transport/primary.hpp"
#include "wrong_pixels.hpp"

namespace sr {

/// The shot with everything in it moved.
[[nodiscard]] inline Shot moved(Shot shot, Vector3<double> offset) {
    for (auto& vertex : shot.scene.mesh.vertices) vertex += offset;
    shot.camera.position += offset;
    return shot;
}

/// The percentage of wrong pixels in float, in world and in camera space, against the distance.
[[nodiscard]] inline course::Chart chart_far_from_the_origin(course::Chapter& chapter, const Shot& shot,
                                                             const VisibilityImage<double>& exact,
                                                             const std::vector<double>&     distances) {
    constexpr double teapot_length = 6.5;  // about, from the handle to the spout

    auto       chart = chapter.chart("far_from_the_origin", "A teapot and its camera, moved together",
                                     {.x   = "distance from the origin [teapot lengths]",
                                      .y   = "pixels that see another triangle [%]",
                                      .log = course::axis::xy});
    const auto wrong = [&](const Mesh<double>& mesh, const Camera<double>& camera) {
        const Hierarchy<float> hierarchy(convert<float>(mesh));
        const TileLoop         loop{.threads = chapter.options().threads};
        return percent_wrong(trace_primary(hierarchy, convert<float>(camera), loop), exact);
    };
    for (const double distance : distances) {
        const auto [scene, camera] =
            moved(shot, teapot_length * distance * normalize(Vector3<double>{3, 4, 5}));
        chart.add("float, world space", distance, wrong(scene.mesh, camera));
        chart.add("float, camera space", distance,
                  wrong(to_camera_space(scene.mesh, camera), in_camera_space(camera)));
    }
    chart.caption(
        "Moved and turned to the camera in double before rounding to float, the scene looks right at any of "
        "these distances.");
    return chart;
}

}  // namespace sr
