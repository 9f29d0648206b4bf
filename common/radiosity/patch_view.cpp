/// @file patch_view.cpp

#include "radiosity/patch_view.hpp"

#include <numbers>
#include <utility>

#include "radiosity/vertex_radiosity.hpp"
#include "sampling/stratum.hpp"

namespace sr {
namespace {

/// The nearest of the faces whose front the ray meets.
class NearestFront : public NearestSearch<double> {
public:
    explicit NearestFront(const Ray<double>& ray)
        : NearestSearch(ray, in_front<double>), direction_{ray.direction} {}

    void offer(const FaceTriangle<double>& candidate) {
        if (dot(area_vector(candidate.triangle), direction_) < 0) NearestSearch::offer(candidate);
    }

private:
    Vector3<double> direction_;
};

}  // namespace

std::optional<SeenPatch> PatchView::seen(const Ray<double>& ray) const {
    NearestFront search(ray);
    Uncounted    uncounted;
    walk(hierarchy_.tree(), search, uncounted);
    const auto& hit = search.result();
    if (!hit) return std::nullopt;
    return SeenPatch{patch_of_face_[hit->face], ray.at(hit->t)};
}

RadiosityAt constant_radiosity(const Radiosities& radiosities) {
    return [&radiosities](const SeenPatch& seen) { return radiosities[seen.patch]; };
}

RadiosityAt interpolated_radiosity(const Patches& patches, Radiosities at_vertices) {
    return [&patches, values = std::move(at_vertices)](const SeenPatch& seen) {
        return interpolated(patches, values, seen.patch, seen.position);
    };
}

Image<Spectrum> picture(const PatchView& view, const Camera<double>& camera, const RadiosityAt& radiosity,
                        int side, const RowLoop& loop) {
    Image<Spectrum> film(camera.width, camera.height);
    const auto      pixel = [&](int x, int y) {
        DoubleSpectrum sum;
        // (8.24) over the pixel: L is B / pi of what is seen
        for (int k = 0; k < side * side; ++k) {
            const auto in_pixel = in_stratum(k, side, Vector2<double>{0.5, 0.5});
            if (const auto seen = view.seen(camera.ray(Vector2<double>{x, y} + in_pixel)))
                sum = sum + radiosity(*seen);
        }
        return convert<float>(sum / (std::numbers::pi * side * side));
    };
    for_each_row(std::size_t(camera.height), loop, [&](std::size_t y) {
        for (int x = 0; x < camera.width; ++x) film(x, int(y)) = pixel(x, int(y));
    });
    return film;
}

}  // namespace sr
