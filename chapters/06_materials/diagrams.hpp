#pragma once
/// @file diagrams.hpp
/// The drawings of sections 6.1, 6.4 and 6.8.

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "lobe_plots.hpp"
#include "material/diffuse.hpp"
#include "material/phong.hpp"
#include "textbook.hpp"

namespace sr {

/// An arc about a point between two angles [degrees] to the upright, with its name beside it.
inline void draw_arc(course::Diagram diagram, course::Point at, double radius, double from, double to,
                     const std::string& name) {
    std::vector<course::Point> arc;
    constexpr int              steps = 20;
    for (int i = 0; i <= steps; ++i) arc.push_back(at + toward(from + (to - from) * i / steps, radius));
    diagram.line(arc, {course::Ink::grey, course::Weight::thin});
    diagram.label(at + toward((from + to) / 2, radius + 0.25), name, course::Anchor::centre,
                  course::Ink::grey);
}

/// Light in a narrow cone, the irradiance that it makes, and the radiance that leaves: equations (6.1) to (6.3).
inline void draw_definition(course::Diagram diagram) {
    using course::Ink;
    using course::Point;
    using course::Weight;
    diagram.polygon({{-3, 0}, {3, 0}, {3, -0.15}, {-3, -0.15}}, {Ink::grey, course::Weight::thin}, 0.35);
    diagram.line({-0.3, 0}, {0.3, 0}, {Ink::black, course::Weight::thick});
    diagram.label({0, -0.42}, "$dA$", course::Anchor::centre);
    diagram.polygon({{0, 0}, toward(45, 2.6), toward(57, 2.6)}, {Ink::amber}, 0.3);
    const Point beside_i = 0.42 * toward(141, 1), beside_o = 0.3 * toward(-128, 1);
    diagram.arrow(toward(51, 2.6) + beside_i, toward(51, 0.8) + beside_i, {Ink::amber, Weight::thick});
    diagram.label(toward(51, 2.6) + beside_i + Point{0.15, 0.0}, "$L_i$ within $d\\omega_i$",
                  course::Anchor::left, Ink::amber);
    diagram.arrow(toward(-38, 0.5) + beside_o, toward(-38, 2.4) + beside_o, {Ink::blue, Weight::thick});
    diagram.label(toward(-38, 2.4) + beside_o + Point{-0.15, 0.1}, "$dL_o = f_r\\, dE_i$",
                  course::Anchor::right, Ink::blue);
    diagram.arrow({0, 0}, toward(51, 2.1));
    diagram.label(toward(51, 2.32), "$\\omega_i$");
    diagram.arrow({0, 0}, toward(-38, 2.1));
    diagram.label(toward(-38, 2.32), "$\\omega_o$", course::Anchor::centre);
    diagram.arrow({0, 0}, {0, 2.3}, {Ink::grey});
    diagram.label({0, 2.5}, "$\\mathbf{n}$", course::Anchor::centre, Ink::grey);
    draw_arc(diagram, {0, 0}, 0.95, 0, 51, "$\\theta_i$");
    draw_arc(diagram, {0, 0}, 0.95, -38, 0, "$\\theta_o$");
    diagram.label({1.0, -0.42}, "$dE_i = L_i\\,\\cos\\theta_i\\,d\\omega_i$", course::Anchor::left,
                  Ink::vermilion);
}

/// Diffuse and two of Phong's lobes, in one scale. All of them give back all light at normal incidence.
inline void draw_lobes(course::Diagram diagram) {
    using course::Ink;
    const auto wo = at_angle(-50);
    for (const int ring : {1, 2, 3}) {
        std::vector<course::Point> arc;
        for (int angle = -90; angle <= 90; angle += 2) arc.push_back(toward(angle, ring));
        diagram.line(arc, {Ink::grey, course::Weight::thin, true});
        diagram.label({-double(ring), -0.5}, fmt::format("{}", ring), course::Anchor::centre, Ink::grey);
    }
    diagram.label({0, -0.5}, "[1/sr]", course::Anchor::centre, Ink::grey);
    const auto phong = [&](double e) {
        return [lobe = Phong<double>{e}, wo](double angle) { return lobe.f(wo, at_angle(angle)); };
    };
    draw_lobe(diagram, {0, 0}, Ink::vermilion, 1, phong(20), -89.9, 89.9);
    draw_lobe(diagram, {0, 0}, Ink::blue, 1, phong(5), -89.9, 89.9);
    const auto diffuse = [&](double angle) { return Diffuse<double>{}.f(wo, at_angle(angle)); };
    draw_lobe(diagram, {0, 0}, Ink::green, 1, diffuse, -89.9, 89.9);
    draw_seen(diagram, {0, 0}, 3.5, 3.7, 50);
    diagram.label({1.7, 2.3}, "$e = 20$", course::Anchor::right, Ink::vermilion);
    diagram.label({1.12, 0.2}, "$e = 5$", course::Anchor::left, Ink::blue);
    diagram.label({-0.4, 0.2}, "diffuse", course::Anchor::right, Ink::green);
}

/// Phong's lobe without a clamp, for an even and an odd exponent.
inline void draw_unclamped(course::Diagram diagram) {
    using course::Ink;
    const auto wo = at_angle(-70);
    for (const int e : {2, 3}) {
        const course::Point at{e == 2 ? 0.0 : 3.5, 0};
        const auto          size = [&](double angle) {
            return std::abs(textbook_phong(wo, at_angle(angle), double(e)));
        };
        draw_lobe(diagram, at, Ink::blue, 1.2, size, -20, 90);
        draw_lobe(diagram, at, Ink::vermilion, 1.2, size, -90, -20);
        draw_seen(diagram, at, 1.6, 1.5, 70);
        diagram.label(at + course::Point{0, -0.3}, e == 2 ? "$e = 2$" : "$e = 3$", course::Anchor::centre);
        diagram.label(at + course::Point{-0.8, 0.85}, e == 2 ? "$f > 0$, behind" : "$f < 0$",
                      course::Anchor::centre, Ink::vermilion);
    }
}

/// Where two media meet: light from above splits in two, light from below may not get out.
inline void draw_interface(course::Diagram diagram) {
    using course::Ink;
    using course::Point;
    using course::Weight;
    const double refracted = degrees(std::asin(std::sin(radians(55)) / 1.5));
    diagram.polygon({{-2.6, 0}, {7.4, 0}, {7.4, -2.1}, {-2.6, -2.1}}, {Ink::sky, Weight::thin}, 0.18);
    for (const double x : {0.0, 4.8}) diagram.line({x, -2}, {x, 2}, {Ink::grey, Weight::thin, true});
    diagram.arrow(toward(-55, 2.3), {0, 0}, {Ink::amber, Weight::thick});
    diagram.arrow({0, 0}, toward(55, 2.3), {Ink::vermilion, Weight::thin});
    diagram.arrow({0, 0}, toward(180 - refracted, 2.3), {Ink::blue, Weight::thick});
    draw_arc(diagram, {0, 0}, 0.85, -55, 0, "$\\theta_i$");
    draw_arc(diagram, {0, 0}, 1.0, 180 - refracted, 180, "$\\theta_t$");
    diagram.label({1.35, 1.45}, "$R$", course::Anchor::centre, Ink::vermilion);
    diagram.label({1.35, -1.15}, "$1 - R$", course::Anchor::left, Ink::blue);
    const Point x{4.8, 0};
    diagram.arrow(x + toward(-125, 2.3), x, {Ink::amber, Weight::thick});
    diagram.arrow(x, x + toward(125, 2.3), {Ink::vermilion, Weight::thick});
    const double critical = 180 + degrees(std::asin(1 / 1.5));
    diagram.line(x, x + toward(critical, 2.3), {Ink::grey, Weight::thin, true});
    draw_arc(diagram, x, 1.2, 180, critical, "$\\theta_c$");
    draw_arc(diagram, x, 1.75, 180, 235, "$\\theta_i$");
    diagram.label(x + Point{1.2, -0.5}, "$R = 1$", course::Anchor::left, Ink::vermilion);
    diagram.label({-2.5, 0.25}, "air, 1", course::Anchor::left, Ink::grey);
    diagram.label({-2.5, -0.28}, "glass, $n$", course::Anchor::left, Ink::grey);
}

}  // namespace sr
