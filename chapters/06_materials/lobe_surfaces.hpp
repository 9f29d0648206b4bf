#pragma once
/// @file lobe_surfaces.hpp
/// Lobes as surfaces: f(wo, wi) as the distance in every direction wi, rendered above the surface that is lit.

#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "course/chapter.hpp"
#include "geometry/hierarchy.hpp"
#include "geometry/offset.hpp"
#include "material/lobe_sum.hpp"
#include "math/frame.hpp"
#include "reflected.hpp"
#include "scene/camera.hpp"
#include "transport/tiles.hpp"

namespace sr {

/// A sheet over u and v from 0 to 1: the point (u, v) for so many steps of each.
template <class At>
[[nodiscard]] Mesh<float> sheet(std::uint32_t rows, std::uint32_t columns, const At& at) {
    Mesh<float> mesh;
    for (std::uint32_t i = 0; i <= rows; ++i) {
        for (std::uint32_t j = 0; j <= columns; ++j)
            mesh.vertices.emplace_back(at(double(i) / rows, double(j) / columns));
    }
    for (std::uint32_t i = 0; i < rows; ++i) {
        for (std::uint32_t j = 0; j < columns; ++j) {
            const std::uint32_t a = i * (columns + 1) + j, b = a + columns + 1;
            mesh.faces.push_back({a, b, a + 1});
            mesh.faces.push_back({a + 1, b, b + 1});
        }
    }
    return mesh;
}

/// The unit vector at the angle v of a turn about +z, so many radians from it.
[[nodiscard]] inline Vector3<double> around(double theta, double v) {
    const double phi = 2 * std::numbers::pi * v;
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

/// A stick from the origin.
[[nodiscard]] inline Mesh<float> stick(const Vector3<double>& to, double radius) {
    const auto frame = frame_around(normalize(to));
    return sheet(1, 24, [&](double u, double v) {
        return u * to + radius * frame.to_world(around(std::numbers::pi / 2, v));
    });
}

/// Sheets, each in its colour.
struct Model {
    Mesh<float>           mesh;
    std::vector<Spectrum> colours;  ///< of the faces

    void add(const Mesh<float>& part, Spectrum colour) {
        const auto first = std::uint32_t(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), part.vertices.begin(), part.vertices.end());
        for (const auto& [a, b, c] : part.faces) mesh.faces.push_back({first + a, first + b, first + c});
        colours.resize(mesh.faces.size(), colour);
    }
};

/// The surface that is lit, the direction from which it is seen, and the lobe.
/// @param f  (wi) -> value [1/sr], drawn with `scale`
template <class F>
[[nodiscard]] Model lobe_model(const Vector3<double>& wo, double scale, Spectrum colour, const F& f) {
    Model model;
    model.add(sheet(2, 96, [](double u, double v) { return 1.15 * u * around(std::numbers::pi / 2, v); }),
              {0.75F, 0.75F, 0.75F});
    model.add(stick(1.6 * wo, 0.018), {0.1F, 0.1F, 0.1F});
    // no lower than the surface, and wo.z > 0: f is 0 on the horizon itself
    model.add(sheet(160, 320,
                    [&](double u, double v) {
                        const auto wi = around(0.4999 * std::numbers::pi * u, v);
                        return scale * f(wi) * wi;
                    }),
              colour);
    return model;
}

/// A portrait's height for this width [pixels].
[[nodiscard]] constexpr int portrait_height(int width) {
    return width * 3 / 4;
}

/// Renders it from the side and above, lit from the upper left, on white.
/// @param progress  told of each row
inline void portray(course::Chapter& chapter, course::Progress& progress, const std::string& name,
                    const std::string& title, const Model& model) {
    const auto&            options = chapter.options();
    const int              size    = options.size;
    const Vector3<double>  from    = normalize(Vector3<double>{0.25, -1, 0.42});
    const auto             camera  = convert<float>(pinhole_camera<double>(
        9.0 * from + Vector3<double>{0, 0, 0.3}, -from, {0, 0, 1}, 1.0, 0.29, size, portrait_height(size)));
    const Hierarchy<float> hierarchy(model.mesh);
    const Vec3             light = normalize(Vec3{-0.5F, -0.7F, 1.0F});
    const auto             seen  = [&](const Ray<float>& ray) {
        const auto hit = hierarchy.nearest(ray);
        if (!hit) return Spectrum{1, 1, 1};
        const Vec3 n = surface_point(model.mesh.triangle(hit->face), hit->uv).normal;
        return (0.25F + 0.75F * std::abs(dot(n, light))) * model.colours[hit->face];
    };
    constexpr int   side = 4;
    Image<Spectrum> film(size, portrait_height(size));
    for_each_pixel(film.width(), film.height(), {.threads = options.threads}, [&](int x, int y) {
        for (int part = 0; part < side * side; ++part) {
            const int  column = part % side, row = part / side;
            const Vec2 at{float(column), float(row)};
            film(x, y) =
                film(x, y) + 1 / float(side * side) *
                                 seen(camera.ray(Vec2(float(x), float(y)) + (at + 0.5F) / float(side)));
        }
        if (x == 0) progress.tick();
    });
    chapter.render(name, title, "The distance from the lit point is f, in every direction.", film);
}

/// The portraits of section 6.4: all seen from 50 degrees, and all of albedo 1 at normal incidence but the last, 0.9.
inline void portray_lobes(course::Chapter& chapter) {
    const auto wo    = at_angle(-50);
    const auto phong = [&](double e) {
        return [lobe = Phong<double>{e}, wo](const Vector3<double>& wi) { return lobe.f(wo, wi); };
    };
    const LobeSum<double> sum{{{{0.7F, 0.7F, 0.7F}, Diffuse<double>{}}, {{0.2F, 0.2F, 0.2F}, Phong{60.0}}}};
    course::Progress      progress("portraying lobes", 4 * portrait_height(chapter.options().size));
    portray(chapter, progress, "lobe_diffuse", "Diffuse",
            lobe_model(wo, 2.8, {0.10F, 0.55F, 0.35F},
                       [&](const auto& wi) { return Diffuse<double>{}.f(wo, wi); }));
    portray(chapter, progress, "lobe_dull", "Phong's lobe, exponent 5",
            lobe_model(wo, 1.1, {0.12F, 0.42F, 0.75F}, phong(5)));
    portray(chapter, progress, "lobe_glossy", "Phong's lobe, exponent 20",
            lobe_model(wo, 0.42, {0.85F, 0.30F, 0.10F}, phong(20)));
    portray(
        chapter, progress, "lobe_sum", "A sum of two",
        lobe_model(wo, 0.62, {0.60F, 0.25F, 0.52F}, [&](const auto& wi) { return double(sum.f(wo, wi).g); }));
}

}  // namespace sr
