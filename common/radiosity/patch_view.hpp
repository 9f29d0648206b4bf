#pragma once
/// @file patch_view.hpp
/// The solution as something that a camera looks up: no light is computed any more. How to use:
///     const PatchView view(patches);
///     const auto film = picture(view, camera, constant_radiosity(B));
///     const auto smooth = picture(view, camera, interpolated_radiosity(patches, vertex_radiosities(patches, B)));
/// or, along one ray:
///     if (const auto seen = view.seen(ray)) show(constant_radiosity(B)(*seen));

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/hierarchy.hpp"
#include "image/image.hpp"
#include "radiosity/patches.hpp"
#include "radiosity/radiosity_system.hpp"
#include "radiosity/rows.hpp"
#include "scene/camera.hpp"

namespace sr {

/// Which patch a ray meets, and where.
struct SeenPatch {
    std::uint32_t   patch;
    Vector3<double> position;
};

/// Patches to be looked at. Only their fronts are seen: from outside one looks into a closed room, and of two sheets
/// back to back one sees that which faces the eye.
class PatchView {
public:
    explicit PatchView(const Patches& patches) : PatchView(mesh_of(patches)) {}

    [[nodiscard]] std::optional<SeenPatch> seen(const Ray<double>& ray) const;

private:
    explicit PatchView(PatchMesh mesh)
        : patch_of_face_(std::move(mesh.patch_of_face)), hierarchy_(mesh.mesh) {}

    std::vector<std::uint32_t> patch_of_face_;
    Hierarchy<double>          hierarchy_;
};

/// The radiosity at a point of a patch [W/m^2].
using RadiosityAt = std::function<DoubleSpectrum(const SeenPatch&)>;

/// That of the whole patch. Refers to the radiosities.
[[nodiscard]] RadiosityAt constant_radiosity(const Radiosities& radiosities);
RadiosityAt               constant_radiosity(const Radiosities&&) = delete;  // would be gone

/// As its vertices' radiosities say, see vertex_radiosity.hpp. Refers to the patches.
[[nodiscard]] RadiosityAt interpolated_radiosity(const Patches& patches, Radiosities at_vertices);
RadiosityAt               interpolated_radiosity(const Patches&&, Radiosities) = delete;

/// The radiance B / pi, equation (8.24), of what each pixel sees [W/(m^2 sr)], as the mean of side^2 rays through the
/// middles of a grid in it; black where nothing is. The same for any number of threads.
/// @pre side >= 1
[[nodiscard]] Image<Spectrum> picture(const PatchView& view, const Camera<double>& camera,
                                      const RadiosityAt& radiosity, int side = 1, const RowLoop& loop = {});

}  // namespace sr
