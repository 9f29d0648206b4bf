#pragma once
/// @file diagrams.hpp
/// The drawings of chapter 1. What they show is computed: pixels that a triangle covers are those that the
/// rasteriser says.

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "course/chapter.hpp"
#include "scene/rasteriser.hpp"

namespace sr {

/// A point of space on paper: z to the right, y up, and x to the lower right, towards us.
[[nodiscard]] inline course::Point on_paper(Vector3<double> p) {
    return {p.z + 0.45 * p.x, p.y - 0.30 * p.x};
}

/// What figure 1.1 is made of: the image plane's distance and its pixel of side 0.5 that the ray goes through, the
/// direction of that ray, and how far along it the surface is.
struct PinholeScene {
    double          f = 4.6;
    Vector3<double> d{0.25, 0.75, f};
    double          t = 2.1;

    std::array<Vector3<double>, 3> surface{{{1, -0.5, 8.75}, {-1, 0, 11.75}, {0, 3.2, 9.9}}};
};

/// The plane's frame, 8 x 6 pixels with the ray's own filled, and the view through its corners.
inline void draw_image_plane(course::Diagram diagram, const PinholeScene& scene) {
    using course::Ink;
    const auto        at = [&](double x, double y) { return on_paper({x, y, scene.f}); };
    const course::Pen thin{Ink::grey, course::Weight::thin};
    for (int i = 0; i <= 8; ++i) diagram.line(at(-2 + 0.5 * i, -1.5), at(-2 + 0.5 * i, 1.5), thin);
    for (int j = 0; j <= 6; ++j) diagram.line(at(-2, -1.5 + 0.5 * j), at(2, -1.5 + 0.5 * j), thin);
    diagram.polygon({at(-2, -1.5), at(2, -1.5), at(2, 1.5), at(-2, 1.5)}, {Ink::blue});
    diagram.polygon({at(0, 0.5), at(0.5, 0.5), at(0.5, 1), at(0, 1)}, {Ink::vermilion}, 0.5);
    for (const double x : {-2.0, 2.0}) {
        for (const double y : {-1.5, 1.5})
            diagram.line(on_paper({0, 0, 0}), at(x, y), {Ink::blue, course::Weight::thin, true});
    }
    diagram.label(on_paper({2, -1.95, scene.f}), "image plane, at distance $f$", course::Anchor::left,
                  Ink::blue);
}

/// The ray from the pinhole to the surface: as far as t = 1 an arrow.
inline void draw_ray(course::Diagram diagram, const PinholeScene& scene) {
    using course::Anchor;
    using course::Ink;
    const auto& [f, d, t, surface] = scene;
    diagram.arrow(on_paper({0, 0, 0}), on_paper(d), {Ink::vermilion, course::Weight::thick});
    diagram.line(on_paper(d), on_paper(t * d), {Ink::vermilion});
    diagram.point(on_paper(t * d), {Ink::vermilion});
    diagram.label(on_paper(0.55 * d) + course::Point{0, 0.38}, "$\\mathbf{d}$", Anchor::centre,
                  Ink::vermilion);
    diagram.label(on_paper(1.5 * d) + course::Point{0, 0.5},
                  "$\\mathbf{r}(t) = \\mathbf{o} + t\\,\\mathbf{d}$", Anchor::centre, Ink::vermilion);
}

/// The pinhole and the camera's axes.
inline void draw_axes(course::Diagram diagram) {
    using course::Anchor;
    const auto at = [](double x, double y, double z) { return on_paper({x, y, z}); };
    for (const auto& tip : {at(1.7, 0, 0), at(0, 1.3, 0), at(0, 0, 1.5)}) diagram.arrow(at(0, 0, 0), tip);
    diagram.point(at(0, 0, 0));
    diagram.label(at(0, 1.62, 0), "$\\mathbf{v}$", Anchor::centre);
    diagram.label(at(2.1, -0.05, 0), "$\\mathbf{u}$", Anchor::centre);
    diagram.label(at(0, -0.02, 1.7), "$\\mathbf{w}$");
    diagram.label(at(0, -0.02, -0.2), "pinhole $\\mathbf{o}$", Anchor::right);
}

/// The pinhole, the image plane before it, and the ray through one pixel.
inline void draw_camera(course::Diagram diagram) {
    using course::Ink;
    const PinholeScene scene;
    const auto& [a, b, c] = scene.surface;
    diagram.polygon({on_paper(a), on_paper(b), on_paper(c)}, {Ink::green}, 0.25);
    diagram.label(on_paper(b) + course::Point{0.15, 0}, "surface", course::Anchor::left, Ink::green);
    draw_image_plane(diagram, scene);
    draw_ray(diagram, scene);
    draw_axes(diagram);
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

/// One of the two panels of figure 1.3: the image, y downwards, on paper.
class LoopPanel {
public:
    LoopPanel(course::Diagram diagram, double left) : diagram_(std::move(diagram)), left_(left) {}

    void square(Vector2<double> centre, double half, course::Ink ink, double opacity) {
        using Corner = Vector2<double>;
        diagram_.polygon({at(centre + Corner{-half, -half}), at(centre + Corner{half, -half}),
                          at(centre + Corner{half, half}), at(centre + Corner{-half, half})},
                         {ink, course::Weight::thin}, opacity);
    }

    void grid() {
        const course::Pen thin{course::Ink::grey, course::Weight::thin};
        for (int x = 0; x <= 12; ++x) diagram_.line(at({x, 0}), at({x, 9}), thin);
        for (int y = 0; y <= 9; ++y) diagram_.line(at({0, y}), at({12, y}), thin);
    }

    void triangle(const LoopScene& scene, std::size_t face, course::Pen pen, double opacity) {
        std::vector<course::Point> corners;
        for (const auto vertex : scene.mesh.faces[face])
            corners.push_back(at(*scene.camera.project(scene.mesh.vertices[vertex])));
        diagram_.polygon(corners, pen, opacity);
    }

    void title(const std::string& text, course::Ink ink) {
        diagram_.label(at({6, -1.2}), text, course::Anchor::centre, ink);
    }

    /// Lines below the image, each farther in than the one before.
    void loops(const std::vector<std::string>& lines) {
        std::string indent;
        double      y = 9.9;
        for (const auto& line : lines) {
            diagram_.label(at({0, y}), indent.empty() ? line : "$" + indent + "$" + line);
            indent += "\\quad";
            y += 1;
        }
    }

private:
    [[nodiscard]] course::Point at(Vector2<double> image) const { return {left_ + image.x, 9 - image.y}; }

    course::Diagram diagram_;
    double          left_;
};

inline constexpr std::array loop_inks{course::Ink::green, course::Ink::blue, course::Ink::purple};

/// One pixel, and all the triangles that it asks.
inline void draw_ray_tracing(LoopPanel panel, const LoopScene& scene) {
    panel.grid();
    for (std::size_t face = 0; face < 3; ++face)
        panel.triangle(scene, face, {loop_inks[face], course::Weight::thick}, 0.12);
    panel.square({6.5, 3.5}, 0.5, course::Ink::vermilion, 0.9);
    panel.title("ray tracing", course::Ink::vermilion);
    panel.loops({"for each pixel:", "for each triangle:", "nearest $t$ on the pixel's ray?"});
}

/// One triangle, the pixels whose centres it asks, and those that it covers.
inline void draw_rasterisation(LoopPanel panel, const LoopScene& scene) {
    constexpr std::size_t asking = 2;
    const Mesh<double>    one{scene.mesh.vertices, {scene.mesh.faces[asking]}};
    const auto            covered = rasterise(one, scene.camera);
    const PixelRange      asked   = pixels_around(one.triangle(0), scene.camera);
    for (int y = asked.y_begin; y < asked.y_end; ++y) {
        for (int x = asked.x_begin; x < asked.x_end; ++x) {
            const bool            hit = covered(x, y).hit();
            const Vector2<double> centre{x + 0.5, y + 0.5};
            if (hit) panel.square(centre, 0.5, loop_inks[asking], 0.35);
            panel.square(centre, 0.06, hit ? loop_inks[asking] : course::Ink::grey, 1);
        }
    }
    panel.grid();
    for (std::size_t face = 0; face < asking; ++face)
        panel.triangle(scene, face, {course::Ink::grey, course::Weight::thin, true}, 0);
    panel.triangle(scene, asking, {loop_inks[asking], course::Weight::thick}, 0);
    panel.title("rasterisation", loop_inks[asking]);
    panel.loops({"for each triangle:", "for each pixel:", "nearer than the stored $t$?"});
}

/// The same image twice: a pixel that asks all triangles, and a triangle that asks all pixels.
inline void draw_two_loops(const course::Diagram& diagram) {
    const LoopScene scene;
    draw_ray_tracing({diagram, 0}, scene);
    draw_rasterisation({diagram, 15}, scene);
}

}  // namespace sr
