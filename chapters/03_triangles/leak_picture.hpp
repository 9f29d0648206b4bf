#pragma once
/// @file leak_picture.hpp
/// Where do rays slip through? A picture in which the edges glow that leak.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "attack.hpp"
#include "course/chapter.hpp"
#include "course/number.hpp"
#include "geometry/hierarchy.hpp"
#include "leaks.hpp"
#include "radiometry/spectrum.hpp"
#include "scene/camera.hpp"

namespace sr {

/// Around one pixel, the rays that were aimed at edges, and how many of them were lost.
struct Attacked {
    float asked = 0, lost = 0;
};

/// Shares a ray out to the four pixels around a point of the image.
inline void add(Image<Attacked>& film, Vector2<double> image, bool lost) {
    const double x = image.x - 0.5, y = image.y - 0.5;
    const int    left = int(std::floor(x)), top = int(std::floor(y));
    for (const int i : {left, left + 1}) {
        for (const int j : {top, top + 1}) {
            if (i < 0 || j < 0 || i >= film.width() || j >= film.height()) continue;
            const auto weight = float((1 - std::abs(x - i)) * (1 - std::abs(y - j)));
            film(i, j).asked += weight;
            film(i, j).lost += lost ? weight : 0;
        }
    }
}

/// The edges that no ray from the point may pass, as aims at their beginnings.
[[nodiscard]] inline std::vector<Aim> walled_off_edges(const Target& target, const Vector3<double>& point) {
    std::vector<Aim> edges;
    for (const auto& face : target.mesh.faces) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const auto a = face[corner], b = face[(corner + 1) % 3];
            if (a < b && target.walls_off(a, point) && target.walls_off(b, point))
                edges.push_back({point, a, b, 0});
        }
    }
    return edges;
}

/// What became of a ray: out of the picture or behind a face, stopped at its edge, or lost.
enum class Fate : std::uint8_t { unseen, stopped, lost };

/// Aims `rays` of them at each edge that is seen and walled off, from the camera, and counts where they go.
/// @pre float holds the camera's position
template <class Method>
[[nodiscard]] Image<Attacked> attack_from(const Camera<double>& camera, const Target& target, int rays,
                                          const TileLoop& loop) {
    const Placement&       here      = placements.front();
    const auto             mesh      = placed<float>(target.mesh, here);
    const auto             triangles = made_ready<Method>(mesh);
    const auto             edges     = walled_off_edges(target, camera.position);
    const Hierarchy<float> hierarchy(mesh);
    const auto             aimed = [&](int i, int edge) {
        Aim aim = edges[std::size_t(edge)];
        aim.u   = (i + 0.5) / rays;
        return aim;
    };
    const auto seen_at = [&](const Ray<float>& ray) {
        return camera.project(camera.position + Vector3<double>(ray.direction));
    };

    Image<Fate> fates(rays, int(edges.size()));
    for_each_pixel(fates.width(), fates.height(), loop, [&](int i, int edge) {
        const auto aim   = aimed(i, edge);
        const auto ray   = placed_ray(aim, mesh, here);
        const auto image = seen_at(ray);
        if (!image || !(std::abs(image->x) < 1e5 && std::abs(image->y) < 1e5)) return;
        if (hierarchy.occluded(ray, {0, 0.999F})) return;
        fates(i, edge) =
            is_stopped<Method>(triangles, target.neighbours, aim, ray) ? Fate::stopped : Fate::lost;
    });

    Image<Attacked> film(camera.width, camera.height);  // its sums are rounded: one order for any threads
    for (int edge = 0; edge < fates.height(); ++edge) {
        for (int i = 0; i < rays; ++i) {
            if (fates(i, edge) == Fate::unseen) continue;
            add(film, *seen_at(placed_ray(aimed(i, edge), mesh, here)), fates(i, edge) == Fate::lost);
        }
    }
    return film;
}

/// What is behind the glow: faces, the brighter the more they face the eye.
[[nodiscard]] inline Image<Spectrum> faces_seen(const Camera<double>& camera, const Mesh<double>& mesh,
                                                const TileLoop& loop) {
    const Hierarchy<double> hierarchy(mesh);
    Image<Spectrum>         film(camera.width, camera.height);
    for_each_pixel(camera.width, camera.height, loop, [&](int x, int y) {
        const auto ray = camera.ray_through_pixel(x, y);
        const auto hit = hierarchy.nearest(ray);
        if (!hit) return;
        const auto n      = normalize(area_vector(mesh.triangle(hit->face)));
        const auto cosine = float(dot(n, normalize(ray.direction)));
        film(x, y)        = (0.004F + 0.04F * cosine * cosine) * Spectrum{0.5F, 0.75F, 1.0F};
    });
    return film;
}

/// Spreads light over some pixels around it, as a lens does that is not clean.
[[nodiscard]] inline Image<float> blurred(Image<float> image, int times) {
    for (int i = 0; i < times; ++i) {
        Image<float> next(image.width(), image.height());
        const auto   at = [&](int x, int y) {
            return image(std::clamp(x, 0, image.width() - 1), std::clamp(y, 0, image.height() - 1));
        };
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x)
                next(x, y) = (at(x - 1, y) + at(x + 1, y) + at(x, y - 1) + at(x, y + 1) + 4 * at(x, y)) / 8;
        }
        image = std::move(next);
    }
    return image;
}

/// An edge that holds is a fine blue line; the more of its rays are lost, the hotter it glows.
inline void add_glow(Image<Spectrum>& film, const Image<Attacked>& attacked) {
    Image<float> heat(film.width(), film.height());
    float        most = 1e-6F;
    for (const auto& pixel : attacked.pixels()) most = std::max(most, pixel.asked);
    for (int y = 0; y < film.height(); ++y) {
        for (int x = 0; x < film.width(); ++x) {
            const auto& pixel = attacked(x, y);
            if (!(pixel.asked > 0)) continue;
            const float line =
                std::min(1.0F, 20 * pixel.asked / most);  // how much of the edge is in the pixel
            heat(x, y) = line * pixel.lost / pixel.asked;
            film(x, y) = film(x, y) + line * Spectrum{0.02F, 0.05F, 0.11F};
        }
    }
    const auto near = blurred(heat, 2 + film.width() / 256), far = blurred(heat, 8 + film.width() / 16);
    for (int y = 0; y < film.height(); ++y) {
        for (int x = 0; x < film.width(); ++x)
            film(x, y) = film(x, y) + 1.5F * heat(x, y) * Spectrum{1.0F, 0.5F, 0.1F} +
                         1.5F * near(x, y) * Spectrum{1.0F, 0.25F, 0.02F} +
                         0.8F * far(x, y) * Spectrum{1.0F, 0.15F, 0.02F};
    }
}

/// Figures 3.3 and 3.4: a sphere and a teapot by Cramer's rule, and the teapot again, watertight.
inline void render_leaks(course::Chapter& chapter, const Target& sphere, const Target& pot) {
    const int  size = chapter.options().size;
    const auto show = [&]<class Method>(Method, const std::string& name, const Target& target,
                                        const Camera<double>& camera, int rays, const std::string& title) {
        course::Progress progress("attacking for " + name, 1000);
        TileLoop         loop{.threads = chapter.options().threads};
        auto             film = faces_seen(camera, target.mesh, loop);
        loop.on_tile          = [&](int done, int of) { progress.tick_part(done, of); };
        add_glow(film, attack_from<Method>(camera, target, rays, loop));
        chapter.render(name, title,
                       fmt::format("{} at each edge; what glows is the share that hits nothing.",
                                   course::counted(rays, "ray")),
                       film);
    };
    const auto inside =
        pinhole_camera<double>({0.375, -0.25, -0.125}, {-1, 0.5, 0.55}, {0, 0, 1}, 1.0, 2.6, size, size);
    const Vector3<double> eye{2.6015625, -8.203125, 4.203125};
    const auto outside = pinhole_camera<double>(eye, Vector3<double>{0.32, 0, 1.4} - eye, {0, 0, 1}, 1.0,
                                                0.86, size, size * 5 / 8);
    show(Cramer<float>{}, "sphere_leaks", sphere, inside, 3 * size,
         "A closed sphere from inside, by Cramer's rule");
    show(Cramer<float>{}, "teapot_leaks", pot, outside, size / 2, "The teapot, by Cramer's rule");
    show(Watertight<float>{}, "teapot_watertight", pot, outside, size / 2, "The teapot, watertight");
}

}  // namespace sr
