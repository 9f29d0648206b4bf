#pragma once
/// @file point_diagrams.hpp
/// Section 9.6: points of the unit square, side by side.

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "course/chapter.hpp"
#include "point_sets.hpp"
#include "sampling/owen.hpp"

namespace sr {

/// The unit square, its lower left corner at `at`, with a name under it.
class SquarePanel {
public:
    SquarePanel(course::Diagram diagram, course::Point at, const std::string& name)
        : diagram_{std::move(diagram)}, at_{at} {
        diagram_.polygon({at, at + course::Point{1, 0}, at + course::Point{1, 1}, at + course::Point{0, 1}},
                         {course::Ink::black, course::Weight::thin});
        diagram_.label(at + course::Point{0.5, -0.09}, name, course::Anchor::centre);
    }

    void point(course::Point p, course::Ink ink = course::Ink::blue) {
        diagram_.point(at_ + p, {ink, course::Weight::thin});
    }

    /// Lines between columns x rows equal boxes.
    void boxes(int columns, int rows) {
        const course::Pen thin{course::Ink::grey, course::Weight::thin};
        for (int i = 1; i < columns; ++i) {
            const double x = double(i) / columns;
            diagram_.line(at_ + course::Point{x, 0}, at_ + course::Point{x, 1}, thin);
        }
        for (int j = 1; j < rows; ++j) {
            const double y = double(j) / rows;
            diagram_.line(at_ + course::Point{0, y}, at_ + course::Point{1, y}, thin);
        }
    }

private:
    course::Diagram diagram_;
    course::Point   at_;
};

/// Six patterns of 64 points.
inline void draw_patterns(course::Chapter& chapter, const std::vector<PointSet>& sets) {
    auto diagram = chapter.diagram("patterns", "64 points, six ways");
    for (std::size_t i = 0; i < sets.size(); ++i) {
        const std::size_t column = i % 3, row = i / 3;
        SquarePanel       panel(diagram, {1.12 * double(column), -1.24 * double(row)}, sets[i].name);
        for (const auto& p : sets[i].points) panel.point(p);
    }
    diagram.caption(
        "Left to right: without knowing of each other; one in each cell; digits mirrored. Below: two bad "
        "dimensions of the same; a net; the net, scrambled.");
}

/// Sixteen points of a net, and the boxes of all shapes that they share out.
inline void draw_net(course::Chapter& chapter) {
    auto       diagram = chapter.diagram("net", "One point in each box, whatever its shape");
    const auto set     = pattern_set<SobolPoint>("", 16);
    for (int k = 0; k <= 4; ++k) {
        const int   columns = 1 << k, rows = 16 / columns;
        SquarePanel panel(diagram, {1.12 * k, 0}, fmt::format("${} \\times {}$", columns, rows));
        panel.boxes(columns, rows);
        for (const auto& p : set.points) panel.point(p);
    }
    diagram.caption("The same 16 points of Sobol's, scrambled, five times.");
}

/// The first `bits` bits of a scrambled number, and of the number itself those that follow.
/// @pre 1 <= bits <= 31
[[nodiscard]] constexpr std::uint32_t partly_scrambled(std::uint32_t v, std::uint32_t seed, int bits) {
    const std::uint32_t rest = ~0U >> bits;
    return (owen_scrambled(v, seed) & ~rest) | (v & rest);
}

/// Owen's scrambling, bit by bit: the points of the left half keep their colour.
inline void draw_scrambling(course::Chapter& chapter) {
    auto                    diagram = chapter.diagram("scrambling", "Owen's scrambling, from bit to bit");
    constexpr std::uint32_t seed_x = 3, seed_y = 11;
    const auto              draw = [&](int place, const std::string& name, int columns, const auto& at) {
        SquarePanel panel(diagram, {1.12 * place, 0}, name);
        panel.boxes(columns, 1);
        for (std::uint32_t i = 0; i < 16; ++i) {
            const std::uint32_t x = sobol(i, 0), y = sobol(i, 1);
            const course::Point p = at(x, y);
            panel.point(p, x >> 31 == 0 ? course::Ink::blue : course::Ink::vermilion);
        }
    };
    const auto partly = [](int bits) {
        return [bits](std::uint32_t x, std::uint32_t y) {
            return 0x1p-32 * course::Point{partly_scrambled(x, seed_x, bits), y};
        };
    };
    draw(0, "Sobol'", 1, [](std::uint32_t x, std::uint32_t y) { return 0x1p-32 * course::Point{x, y}; });
    draw(1, "first bit of $x$", 2, partly(1));
    draw(2, "two bits of $x$", 4, partly(2));
    draw(3, "all, $x$ and $y$", 1, [](std::uint32_t x, std::uint32_t y) {
        return 0x1p-32 * course::Point{owen_scrambled(x, seed_x), owen_scrambled(y, seed_y)};
    });
    diagram.caption(
        "Halves change places, or not; in each of them quarters, and so on. Colour: the half of $x$ in which "
        "a point began.");
}

}  // namespace sr
