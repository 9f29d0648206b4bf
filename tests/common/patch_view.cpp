/// @file patch_view.cpp
/// A solution seen by a camera: B / pi of the front that a ray meets.

#include "radiosity/patch_view.hpp"

#include <doctest/doctest.h>

#include <numbers>
#include <utility>

#include "near.hpp"
#include "radiosity/vertex_radiosity.hpp"

using namespace sr;
using sr::test::near;

namespace {

using std::numbers::pi;

/// A square in the plane z = 0 that faces +z, and perhaps what lies behind it.
Patches sheet(ShiningSides sides = ShiningSides::front, double size = 1) {
    const Scene scene{.mesh      = {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}},
                      .materials = {diffuse_material("paint", {0.5F, 0.5F, 0.5F})},
                      .material_of_face = {0, 0}};
    return cut(polygons_of(scene, sides), size);
}

/// Sees [-1/2, 3/2]^2 of the plane z = 0 from z = +-1.
Camera<double> camera_at(double z, int side = 8) {
    return pinhole_camera<double>({0.5, 0.5, z}, {0, 0, -z}, {0, 1, 0}, 1, 2, side, side);
}

}  // namespace

TEST_CASE("a patch is seen with radiance B / pi, from its front only") {
    const Patches     patches = sheet();
    const PatchView   view(patches);
    const Radiosities B{{pi, 2 * pi, 0}};
    const auto        before = picture(view, camera_at(1), constant_radiosity(B));
    const auto        behind = picture(view, camera_at(-1), constant_radiosity(B));
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) {
            const bool inside = x >= 2 && x < 6 && y >= 2 && y < 6;
            CHECK(before(x, y) == (inside ? Spectrum{1, 2, 0} : Spectrum{}));
            CHECK(behind(x, y) == Spectrum{});
        }
    const auto mean = picture(view, camera_at(1, 2), constant_radiosity(B), 4);
    CHECK(mean(0, 0).g == near(0.5, 1e-6));  // a quarter of what the pixel sees
}

TEST_CASE("of two sheets back to back each is seen from its side") {
    const Patches     patches = sheet(ShiningSides::both, 0.3);
    const PatchView   view(patches);
    Radiosities       B;
    const std::size_t half = patches.size() / 2;
    for (std::size_t i = 0; i < patches.size(); ++i)
        B.push_back(i < half ? DoubleSpectrum{pi, 0, 0} : DoubleSpectrum{0, pi, 0});
    CHECK(picture(view, camera_at(1), constant_radiosity(B))(4, 4) == Spectrum{1, 0, 0});
    CHECK(picture(view, camera_at(-1), constant_radiosity(B))(4, 4) == Spectrum{0, 1, 0});
}

TEST_CASE("what a radiosity refers to can't be a temporary") {
    const auto constant = [](auto&& B) {
        return requires {
            constant_radiosity(std::forward<decltype(B)>(B));
        };
    };
    const auto interpolated = [](auto&& patches) {
        return requires {
            interpolated_radiosity(std::forward<decltype(patches)>(patches), Radiosities{});
        };
    };
    const Radiosities B;
    const Patches     patches;
    CHECK(constant(B));
    CHECK(!constant(Radiosities{}));
    CHECK(interpolated(patches));
    CHECK(!interpolated(Patches{}));
}

TEST_CASE("interpolated, a slope is seen as a slope, the same for any number of threads") {
    const Patches   patches = sheet(ShiningSides::front, 0.25);
    const PatchView view(patches);
    Radiosities     B;
    for (const auto& shape : patches.shapes) B.push_back({shape.centre().x, shape.centre().y, 1});
    const auto radiosity = interpolated_radiosity(patches, vertex_radiosities(patches, B));
    const auto film      = picture(view, camera_at(1, 64), radiosity, 2);
    for (const auto& [x, y] : {std::pair{17, 30}, {30, 17}, {46, 46}}) {
        CHECK(film(x, y).r == near((-0.5 + (x + 0.5) / 32) / pi, 1e-6));
        CHECK(film(x, y).g == near((1.5 - (y + 0.5) / 32) / pi, 1e-6));
        CHECK(film(x, y).b == near(1 / pi, 1e-6));
    }
    CHECK(film == picture(view, camera_at(1, 64), radiosity, 2, {.threads = 7}));
    CHECK(!(film == picture(view, camera_at(1, 64), constant_radiosity(B), 2)));
}
