#pragma once
/// @file form_factor_diagrams.hpp
/// Sections 8.2 and 8.3: what a form factor is made of, Nusselt's picture of it, and the hemicube's.

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "course/diagram.hpp"
#include "drawing.hpp"
#include "math/vector.hpp"

namespace sr {

/// Two patches, a point on each, the line between them and its angles with the normals.
inline void draw_form_factor(course::Diagram diagram) {
    const Point p{0, 0}, q{6.4, 3.4};
    diagram.polygon({{-2.4, -0.9}, {1.4, -0.9}, {2.6, 0.9}, {-1.2, 0.9}}, {Ink::blue}, 0.18);
    diagram.polygon({{5.3, 4.6}, {6.3, 1.4}, {7.6, 2.3}, {6.6, 5.5}}, {Ink::green}, 0.18);
    diagram.polygon({{-0.42, -0.16}, {0.25, -0.16}, {0.46, 0.16}, {-0.21, 0.16}}, {Ink::blue, Weight::thin},
                    0.5);
    diagram.polygon({{6.2, 3.6}, {6.38, 3.02}, {6.6, 3.17}, {6.42, 3.75}}, {Ink::green, Weight::thin}, 0.5);
    diagram.line(p, q, {Ink::vermilion, Weight::thick});
    const double line = std::atan2(3.4, 6.4) * 180 / 3.14159265358979324, normal_q = 197;
    diagram.arrow(p, {0, 3}, {Ink::blue, Weight::medium});
    diagram.arrow(q, q + 2.9 * towards(normal_q), {Ink::green, Weight::medium});
    draw_angle(diagram, p, 1.3, line, 90, "$\\theta$", 1.35);
    draw_angle(diagram, q, 1.6, normal_q, 180 + line, "$\\theta'$", 1.35);
    diagram.label({0, 3.35}, "$\\mathbf{n}$", Anchor::centre, Ink::blue);
    diagram.label(q + 3.25 * towards(normal_q), "$\\mathbf{n}'$", Anchor::centre, Ink::green);
    diagram.label({3.75, 1.55}, "$r$", Anchor::centre, Ink::vermilion);
    diagram.label({0.55, -0.4}, "$dA$", Anchor::left, Ink::blue);
    diagram.label({6.42, 2.62}, "$dA'$", Anchor::left, Ink::green);
    diagram.label({-2.0, -1.4}, "patch $i$, $A_i$", Anchor::left, Ink::blue);
    diagram.label({7.0, 5.6}, "patch $j$, $A_j$", Anchor::left, Ink::green);
}

/// A point of space on the paper, seen from 20 degrees above: x to the right, y away, z up.
[[nodiscard]] inline Point from_aslant(const Vector3<double>& p) {
    const Point above = towards(20);
    return {p.x, above.x * p.z + above.y * p.y};
}

/// The border of a patch above a unit disk, of its image on the unit sphere, and of that image's shadow on the disk.
struct Nusselt {
    std::vector<Point> patch, image, shadow,
        rays;  ///< the last: what ends of the four corners' lines there are

    explicit Nusselt(const std::array<Vector3<double>, 4>& corners) {
        constexpr int pieces = 24;  // of a side
        for (std::size_t side = 0; side < 4; ++side) {
            for (int i = 0; i < pieces; ++i) {
                const auto p = glm::mix(corners[side], corners[(side + 1) % 4], double(i) / pieces);
                const auto q = normalize(p);
                if (i == 0) patch.push_back(from_aslant(p));
                image.push_back(from_aslant(q));
                shadow.push_back(from_aslant({q.x, q.y, 0}));
                if (i == 0) rays.insert(rays.end(), {patch.back(), image.back(), shadow.back()});
            }
        }
    }
};

inline void draw_nusselt(course::Diagram diagram) {
    const Nusselt of({{{0.5, -0.5, 1.35}, {1.6, -0.5, 0.75}, {1.6, 0.7, 0.75}, {0.5, 0.7, 1.35}}});
    const Point   centre{0, 0}, right{1, 0}, away = from_aslant({0, 1, 0}),
                                           up{0, 1};  // of the sphere's outline
    diagram.polygon(course::ellipse(centre, right, away), {Ink::blue, Weight::medium}, 0.1);
    diagram.line(course::ellipse(centre, right, up, 0, 180), {Ink::black, Weight::thin});
    for (std::size_t i = 0; i < of.rays.size(); i += 3) {
        diagram.line(centre, of.rays[i], {Ink::green, Weight::thin});
        diagram.line(of.rays[i + 1], of.rays[i + 2], {Ink::vermilion, Weight::thin, true});
    }
    diagram.polygon(of.shadow, {Ink::vermilion, Weight::medium}, 0.6);
    diagram.polygon(of.image, {Ink::vermilion, Weight::medium}, 0.35);
    diagram.polygon(of.patch, {Ink::green, Weight::medium}, 0.25);
    diagram.point(centre, {Ink::blue});
    diagram.label(centre + Point{-0.05, -0.08}, "$dA$", Anchor::right, Ink::blue);
    diagram.label(of.patch[2] + Point{0.06, 0}, "patch $j$", Anchor::left, Ink::green);
    diagram.label(of.image.front() + Point{-0.08, 0.02}, "$\\Omega$", Anchor::right, Ink::vermilion);
    diagram.label(of.shadow[24] + Point{0.05, -0.12}, "$\\Omega_\\perp$", Anchor::left, Ink::vermilion);
    diagram.label({-1.15, 0.2}, "radius 1", Anchor::right);
    diagram.label({-2.6, 1.25}, "$F = \\Omega_\\perp / \\pi$: of the disk's area,");
    diagram.label({-2.6, 1.08}, "the share below the image");
}

/// In a section: a patch under half a cube, whose pixels see other patches.
inline void draw_hemicube(course::Diagram diagram) {
    constexpr int pixels = 12;
    const Point   eye{0, 0};
    const Point   a{4.2, 5.2}, b{7.2, 2.4};
    diagram.polygon({eye, a, b}, {Ink::green, Weight::thin}, 0.1);
    diagram.line(a, b, {Ink::green, Weight::thick});
    diagram.line({-5, 0}, {5, 0}, {Ink::blue, Weight::thick});
    const auto sees = [&](Point pixel) {
        return pixel.y * b.x > pixel.x * b.y && pixel.y * a.x < pixel.x * a.y;
    };
    const auto draw = [&](Point from, Point to) {
        const Point middle = (from + to) / 2.0;
        diagram.line(
            from, to,
            {sees(middle) ? Ink::vermilion : Ink::black, sees(middle) ? Weight::thick : Weight::medium});
        const Point outwards =
            std::abs(from.x - to.x) > 0.01 ? Point{0, 0.16} : Point{from.x > 0 ? 0.16 : -0.16, 0};
        diagram.line(from - outwards, from + outwards, {Ink::black, Weight::thin});
    };
    constexpr double side = 2.4, step = 2 * side / pixels;
    for (int i = 0; i < pixels; ++i) draw({-side + i * step, side}, {-side + (i + 1) * step, side});
    for (int i = 0; i < pixels / 2; ++i)
        for (const double x : {-side, side}) draw({x, i * step}, {x, (i + 1) * step});
    diagram.point(eye, {Ink::blue});
    diagram.label({0, -0.5}, "middle of patch $i$", Anchor::centre, Ink::blue);
    diagram.label((a + b) / 2.0 + Point{0.3, 0.3}, "patch $j$", Anchor::left, Ink::green);
    diagram.label({-2.7, 2.9}, "pixels, each worth $\\Delta F$", Anchor::right);
    diagram.label({1.2, 3.0}, "$\\Sigma\\, \\Delta F$", Anchor::right, Ink::vermilion);
}

}  // namespace sr
