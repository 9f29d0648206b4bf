#pragma once
/// @file gallery.hpp
/// The five surfaces of section 2.4, and their portraits.

#include <cmath>
#include <concepts>
#include <optional>
#include <string>

#include "course/chapter.hpp"
#include "geometry/implicit_closed_form.hpp"
#include "geometry/implicit_ellipsoid.hpp"
#include "geometry/implicit_hyperboloid.hpp"
#include "geometry/implicit_marching.hpp"
#include "geometry/implicit_metaballs.hpp"
#include "geometry/implicit_normal.hpp"
#include "geometry/implicit_tanglecube.hpp"
#include "geometry/implicit_torus.hpp"
#include "scene/camera.hpp"
#include "transport/tiles.hpp"

namespace sr {

template <std::floating_point T>
inline constexpr Torus<T> shown_torus{2, T(0.5)};

template <std::floating_point T>
[[nodiscard]] Metaballs<T> shown_metaballs() {
    return {{{{0, 0, 0}, T(1.1)},
             {{T(1.5), T(0.2), T(0.3)}, T(0.75)},
             {{T(-1.3), T(-0.6), T(-0.3)}, T(0.8)},
             {{T(-0.5), T(0.4), T(1.5)}, T(0.7)},
             {{T(0.9), T(-1.2), T(-0.9)}, T(0.6)}},
            T(0.5)};
}

/// The first hit of whatever surface, by a polynomial if its f is one, else by steps that are short here.
template <std::floating_point T, ImplicitSurface<T> Surface>
[[nodiscard]] std::optional<T> first_hit(const Surface& surface, const Ray<T>& ray) {
    if constexpr (AlgebraicSurface<Surface, T>) {
        return solve(surface, ray, in_front<T>);
    } else {
        return march(surface, ray, in_front<T>, T(0.05) / length(ray.direction));
    }
}

/// Two colours, of the outside and of the inside where that is seen.
struct Paint {
    Spectrum outside, inside;
};

/// A surface lit from where it is seen, equation (1.4), on white.
template <class Surface>
[[nodiscard]] Spectrum portrayed(const Surface& surface, const Ray<float>& ray, const Paint& paint) {
    const auto t = first_hit(surface, ray);
    if (!t) return {1, 1, 1};
    const float cosine =
        -dot(normal(surface, ray.at(*t), ray.direction), ray.direction) / length(ray.direction);
    return cosine > 0 ? cosine * paint.outside : -cosine * paint.inside;
}

/// Renders one surface from the front, above and right; z is up, and a ball of this radius fills the picture.
template <class Surface>
void portray(course::Chapter& chapter, const std::string& name, const std::string& title,
             const Surface& surface, double radius, const Paint& paint) {
    const auto&           options = chapter.options();
    const Vector3<double> from    = normalize(Vector3<double>{0.55, -1, 0.62});
    const auto            camera  = convert<float>(
        pinhole_camera<double>(4.2 * radius * from, -from, {0, 0, 1}, 1.0, 0.5, options.size, options.size));
    const int        side = int(std::sqrt(options.samples));  // a square: course::run has seen to that
    Image<Spectrum>  film(options.size, options.size);
    course::Progress progress("tracing " + name, 1000);
    const TileLoop   loop{.threads = options.threads,
                          .on_tile = [&](int done, int of) { progress.tick_part(done, of); }};
    for_each_pixel(film.width(), film.height(), loop, [&](int x, int y) {
        for (int part = 0; part < side * side; ++part) {
            const int  row = part / side, column = part % side;
            const Vec2 at{float(column), float(row)};
            const auto ray = camera.ray(Vec2(float(x), float(y)) + (at + 0.5F) / float(side));
            film(x, y)     = film(x, y) + 1 / float(side * side) * portrayed(surface, ray, paint);
        }
    });
    chapter.render(name, title, "A light at the eye, equation (1.4).", film);
}

/// The gallery.
inline void portray_all(course::Chapter& chapter) {
    portray(chapter, "ellipsoid", "An ellipsoid", Ellipsoid<float>{{1, 0.7F, 1.2F}}, 1.35,
            {{0.80F, 0.25F, 0.10F}, {0.5F, 0.5F, 0.5F}});
    portray(chapter, "hyperboloid", "A hyperboloid", Hyperboloid<float>{{0.6F, 0.6F, 0.7F}, 1.3F}, 1.85,
            {{0.12F, 0.42F, 0.70F}, {0.85F, 0.65F, 0.15F}});
    portray(chapter, "torus", "A torus", shown_torus<float>, 2.6,
            {{0.85F, 0.55F, 0.08F}, {0.5F, 0.5F, 0.5F}});
    portray(chapter, "tanglecube", "The tanglecube", Tanglecube<float>{}, 3.4,
            {{0.10F, 0.50F, 0.32F}, {0.5F, 0.5F, 0.5F}});
    portray(chapter, "metaballs", "Five metaballs", shown_metaballs<float>(), 2.1,
            {{0.58F, 0.26F, 0.55F}, {0.5F, 0.5F, 0.5F}});
}

}  // namespace sr
