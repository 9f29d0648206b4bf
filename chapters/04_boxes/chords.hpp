#pragma once
/// @file chords.hpp
/// What lines from everywhere see of a convex body: how often they meet it, and how long they are in it.

#include <cmath>
#include <numbers>
#include <optional>

#include "convex_bodies.hpp"
#include "isotropic_lines.hpp"
#include "statistics/running.hpp"

namespace sr {

/// Over the lines that meet a ball around the body: whether they meet the body; over those that do, powers of the
/// length inside.
struct Chords {
    Running met, length, square, fourth;

    void add(double chord, bool meets) {
        met.add(meets ? 1 : 0);
        if (!meets) return;
        length.add(chord);
        square.add(chord * chord);
        fourth.add(chord * chord * chord * chord);
    }
    void merge(const Chords& other) {
        met.merge(other.met);
        length.merge(other.length);
        square.merge(other.square);
        fourth.merge(other.fourth);
    }
};

[[nodiscard]] inline Chords measure_chords(const ConvexBody& body, const Draw& draw) {
    const Sphere<double> around{{0, 0, 0}, body.circumradius};
    return over_lines<Chords>(around, draw, [&](Chords& chords, const Ray<double>& line) {
        const auto inside = clip(body, line);
        chords.add(inside.max - inside.min, !inside.empty());
    });
}

/// The body's mean projected area: the share of the disk that lines are drawn from.
[[nodiscard]] inline double mean_shadow(const Chords& chords, const ConvexBody& body) {
    return chords.met.mean() * std::numbers::pi * body.circumradius * body.circumradius;
}

/// Over the lines that meet the outer body, whether they meet the inner one.
/// @param eye  a point that all lines pass through; without one they come from everywhere
[[nodiscard]] inline Running measure_nested(const ConvexBody& inner, const ConvexBody& outer,
                                            const Draw&                    draw,
                                            std::optional<Vector3<double>> eye = std::nullopt) {
    const Sphere<double> around{{0, 0, 0}, outer.circumradius};
    return over_lines<Running>(around, draw, [&](Running& met, Ray<double> line) {
        if (eye) line.origin = *eye;
        if (!clip(outer, line).empty()) met.add(clip(inner, line).empty() ? 0 : 1);
    });
}

}  // namespace sr
