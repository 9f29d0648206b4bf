#pragma once
/// @file diagrams.hpp
/// The drawings of chapter 1. What they show is computed: pixels that a triangle covers are those that the
/// rasteriser says.

#include <array>
#include <string>
#include <vector>

#include "course/chapter.hpp"
#include "scene/rasteriser.hpp"

namespace sr {

/// A point of space on paper: z to the right, y up, and x to the lower right, towards us.
[[nodiscard]] inline course::Point on_paper(Vector3<double> p) {
    return {p.z + 0.45 * p.x, p.y - 0.30 * p.x};
}

/// The pinhole, the image plane before it, and the ray through one pixel.
inline void draw_camera(course::Diagram diagram) {
    using course::Ink;
    using V             = Vector3<double>;
    constexpr double f  = 4.6;  // the plane's distance
    const auto       at = [](double x, double y, double z) { return on_paper({x, y, z}); };

    const std::array<V, 3> surface{V{1, -0.5, 8.75}, V{-1, 0, 11.75}, V{0, 3.2, 9.9}};
    diagram.polygon({on_paper(surface[0]), on_paper(surface[1]), on_paper(surface[2])}, {Ink::green}, 0.25);

    // The plane's frame, 8 x 6 pixels of side 0.5, and the pixel that the ray goes through.
    const course::Pen thin{Ink::grey, course::Weight::thin};
    for (int i = 0; i <= 8; ++i) diagram.line(at(-2 + 0.5 * i, -1.5, f), at(-2 + 0.5 * i, 1.5, f), thin);
    for (int j = 0; j <= 6; ++j) diagram.line(at(-2, -1.5 + 0.5 * j, f), at(2, -1.5 + 0.5 * j, f), thin);
    diagram.polygon({at(-2, -1.5, f), at(2, -1.5, f), at(2, 1.5, f), at(-2, 1.5, f)}, {Ink::blue});
    diagram.polygon({at(0, 0.5, f), at(0.5, 0.5, f), at(0.5, 1, f), at(0, 1, f)}, {Ink::vermilion}, 0.5);
    for (const double x : {-2.0, 2.0}) {
        for (const double y : {-1.5, 1.5}) {
            diagram.line(at(0, 0, 0), at(x, y, f), {Ink::blue, course::Weight::thin, true});
        }
    }

    const V      d{0.25, 0.75, f};
    const double t = 2.1;
    diagram.arrow(at(0, 0, 0), on_paper(d), {Ink::vermilion, course::Weight::thick});
    diagram.line(on_paper(d), on_paper(t * d), {Ink::vermilion});
    diagram.point(on_paper(t * d), {Ink::vermilion});
    for (const V& axis : {V{1.7, 0, 0}, V{0, 1.3, 0}, V{0, 0, 1.5}})
        diagram.arrow(at(0, 0, 0), on_paper(axis));
    diagram.point(at(0, 0, 0));

    using course::Anchor;
    diagram.label(at(0, 1.55, 0), "$\\mathbf{v}$", Anchor::centre);
    diagram.label(at(2.1, -0.05, 0), "$\\mathbf{u}$", Anchor::centre);
    diagram.label(at(0, -0.02, 1.62), "$\\mathbf{w}$");
    diagram.label(at(0, -0.02, -0.2), "pinhole $\\mathbf{o}$", Anchor::right);
    diagram.label(at(2, -1.95, f), "image plane, at distance $f$", Anchor::left, Ink::blue);
    diagram.label(on_paper(0.55 * d) + course::Point{0, 0.3}, "$\\mathbf{d}$", Anchor::centre,
                  Ink::vermilion);
    diagram.label(on_paper(1.42 * d) + course::Point{0, 0.32},
                  "$\\mathbf{r}(t) = \\mathbf{o} + t\\,\\mathbf{d}$", Anchor::centre, Ink::vermilion);
    diagram.label(on_paper(surface[1]) + course::Point{0.15, 0}, "surface", Anchor::left, Ink::green);
}

/// Three triangles before an image of 12 x 9 pixels, the last in front of the others.
struct LoopScene {
    Mesh<double>   mesh{{{-4.6, -2.6, 9},
                         {1.8, -1.2, 9},
                         {-2.4, 3.3, 9},
                         {0.4, -3.4, 8},
                         {5.0, -2.4, 8},
                         {3.4, 1.9, 8},
                         {-1.9, -0.4, 6},
                         {2.6, 0.6, 6},
                         {0.6, 2.6, 6}},
                      {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}}};
    Camera<double> camera = pinhole_camera<double>({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 0.9, 1.2, 12, 9);
};

/// The same image twice: a pixel that asks all triangles, and a triangle that asks all pixels.
inline void draw_two_loops(course::Diagram diagram) {
    using course::Ink;
    const LoopScene          scene;
    const std::array<Ink, 3> inks{Ink::green, Ink::blue, Ink::purple};
    constexpr double         right_panel = 15;
    const auto               on_panel    = [](Vector2<double> image, double shift) {
        return course::Point{image.x + shift, 9 - image.y};
    };
    const auto pixel = [&](int x, int y, double shift, Ink ink, double opacity) {
        const Vector2<double> p{x, y};
        diagram.polygon(
            {on_panel(p, shift), on_panel(p + Vector2<double>{1, 0}, shift),
             on_panel(p + Vector2<double>{1, 1}, shift), on_panel(p + Vector2<double>{0, 1}, shift)},
            {ink, course::Weight::thin}, opacity);
    };

    // Right: the pixels of one triangle, as the rasteriser finds them.
    const Mesh<double> one{scene.mesh.vertices, {scene.mesh.faces[2]}};
    const auto         covered      = rasterise(one, scene.camera);
    const PixelRange   asked_pixels = pixels_around(one.triangle(0), scene.camera);
    for (int y = asked_pixels.y_begin; y < asked_pixels.y_end; ++y) {
        for (int x = asked_pixels.x_begin; x < asked_pixels.x_end; ++x) {
            if (covered(x, y).hit()) pixel(x, y, right_panel, inks[2], 0.35);
            const course::Point centre = on_panel({x + 0.5, y + 0.5}, right_panel);
            const double        r      = 0.06;
            diagram.polygon({centre + course::Point{-r, -r}, centre + course::Point{r, -r},
                             centre + course::Point{r, r}, centre + course::Point{-r, r}},
                            {covered(x, y).hit() ? inks[2] : Ink::grey, course::Weight::thin}, 1);
        }
    }
    for (const double shift : {0.0, right_panel}) {
        for (int x = 0; x <= 12; ++x)
            diagram.line({x + shift, 0}, {x + shift, 9}, {Ink::grey, course::Weight::thin});
        for (int y = 0; y <= 9; ++y)
            diagram.line({shift, y}, {shift + 12, y}, {Ink::grey, course::Weight::thin});
        for (std::size_t face = 0; face < 3; ++face) {
            std::vector<course::Point> corners;
            for (const auto vertex : scene.mesh.faces[face]) {
                corners.push_back(on_panel(*scene.camera.project(scene.mesh.vertices[vertex]), shift));
            }
            const bool asked = shift == 0 || face == 2;
            diagram.polygon(corners,
                            {asked ? inks[face] : Ink::grey,
                             asked ? course::Weight::thick : course::Weight::thin, !asked},
                            shift == 0 ? 0.12 : 0.0);
        }
    }
    pixel(6, 3, 0, Ink::vermilion, 0.9);
    diagram.label({6, 10.2}, "ray tracing", course::Anchor::centre, Ink::vermilion);
    diagram.label({6 + right_panel, 10.2}, "rasterisation", course::Anchor::centre, Ink::purple);
    diagram.label({0, -0.9}, "for each pixel:");
    diagram.label({0, -1.9}, "   for each triangle:");
    diagram.label({0, -2.9}, "      nearest $t$ on the pixel's ray?");
    diagram.label({right_panel, -0.9}, "for each triangle:");
    diagram.label({right_panel, -1.9}, "   for each pixel:");
    diagram.label({right_panel, -2.9}, "      nearer than the stored $t$?");
}

}  // namespace sr
