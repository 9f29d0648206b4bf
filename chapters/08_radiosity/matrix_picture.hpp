#pragma once
/// @file matrix_picture.hpp
/// The Cornell box's form factors, all of them at once.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "cornell_solution.hpp"

namespace sr {

/// Where each named part's patches begin, and after them the number of all. Whatever the floor is cut into comes first.
[[nodiscard]] inline std::vector<std::size_t> first_patches(const Patches& patches) {
    std::vector<std::size_t> first{0};
    std::uint32_t            polygons = patches.polygon.back() + 1;
    for (const auto& part : parts_of_the_box) polygons -= part.polygons;
    for (const auto& part : parts_of_the_box) {
        polygons += part.polygons;
        const auto begin = std::lower_bound(patches.polygon.begin(), patches.polygon.end(), polygons);
        first.push_back(std::size_t(begin - patches.polygon.begin()));
    }
    return first;
}

/// Of F_ij: 0, black, where it is 0 or at most 1e-6, 1, white, where it is 0.1 or more, and in between a step for each
/// factor of 10^(1/4). More than these 20 are not told apart, and fill files.
[[nodiscard]] inline double shade_of(double F) {
    return F > 0 ? std::clamp(std::round((std::log10(F) + 6) * 4) / 20, 0.0, 1.0) : 0;
}

/// Row i, column j: the shade of F_ij. Lines between the parts.
[[nodiscard]] inline Image<Spectrum> matrix_picture(const SolvedScene& box) {
    const auto      first = first_patches(box.patches);
    const auto      n     = box.patches.size();
    const auto      side  = int(n + first.size() - 2);
    Image<Spectrum> film(side, side, {0.8F, 0.15F, 0.02F});
    const auto      place = [&](std::size_t i) {  // as many lines are before it as parts begin up to there
        return int(i) + int(std::upper_bound(first.begin(), first.end(), i) - first.begin()) - 1;
    };
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) {
            const double shade       = shade_of(box.system.form_factors(i, j));
            const auto   grey        = float(shade * shade);  // as radiance; a screen shows about its root
            film(place(j), place(i)) = {grey, grey, grey};
        }
    return film;
}

/// The picture's lines, what they are between, and what its greys mean.
inline void draw_matrix_key(course::Diagram diagram, const SolvedScene& box) {
    using course::Anchor, course::Ink, course::Weight;
    const auto       first = first_patches(box.patches);
    const double     n     = double(box.patches.size());
    constexpr double side = 10, gap = 0.62;
    const auto       at = [&](std::size_t part) { return side * double(first[part]) / n; };
    for (std::size_t line = 0; line < first.size(); ++line) {
        diagram.line({0, side - at(line)}, {side, side - at(line)}, {Ink::vermilion, Weight::thin});
        diagram.line({at(line), 0}, {at(line), side}, {Ink::vermilion, Weight::thin});
    }
    double below = side;  // the last label, which the next one does not cover
    for (std::size_t part = 0; part + 1 < first.size(); ++part) {
        const double middle = (at(part) + at(part + 1)) / 2, y = std::min(side - middle, below - gap);
        diagram.label({-0.2, y}, fmt::format("{} {}", parts_of_the_box[part].name, part + 1), Anchor::right);
        diagram.label({side - y, side + 0.45}, fmt::format("{}", part + 1), Anchor::centre);
        below = y;
    }
    for (int power = 0; power <= 5; ++power) {
        const double y = side - 1 - 0.8 * power;
        diagram.polygon({{11, y - 0.4}, {12, y - 0.4}, {12, y + 0.4}, {11, y + 0.4}},
                        {Ink::black, Weight::thin}, 1 - shade_of(std::pow(10.0, -1 - power)));
        diagram.label({12.3, y}, fmt::format("$10^{{{}}}${}", -1 - power,
                                             power == 0   ? " and more"
                                             : power == 5 ? " and less"
                                                          : ""));
    }
}

/// Of patches that are not in part below a block: the share of the light leaving one part that arrives at each other,
/// and last of what leaves the box.
[[nodiscard]] inline std::vector<std::vector<double>> shares_between_parts(const SolvedScene& box) {
    const auto                       first = first_patches(box.patches);
    const std::size_t                parts = std::size(parts_of_the_box);
    std::vector<std::vector<double>> shares(parts, std::vector<double>(parts + 1));
    for (std::size_t p = 0; p < parts; ++p) {
        double area = 0;
        for (std::size_t i = first[p]; i < first[p + 1]; ++i) {
            area += box.system.area[i];
            for (std::size_t q = 0; q < parts; ++q)
                for (std::size_t j = first[q]; j < first[q + 1]; ++j)
                    shares[p][q] += box.system.area[i] * box.system.form_factors(i, j);
        }
        for (auto& share : shares[p]) share /= area;
        shares[p][parts] = 1;
        for (std::size_t q = 0; q < parts; ++q) shares[p][parts] -= shares[p][q];
    }
    return shares;
}

/// The matrix of the parts, in per cent.
inline void draw_parts(course::Diagram diagram, const SolvedScene& box) {
    using course::Anchor, course::Ink, course::Weight;
    const auto   shares = shares_between_parts(box);
    const auto   parts  = int(std::size(parts_of_the_box));
    const double wide = 1.6, high = 0.8;
    const auto   name = [&](int part) {
        return part == parts ? std::string("out") : std::string(parts_of_the_box[part].name);
    };
    diagram.label({-0.15 * wide, (parts + 0.95) * high}, "[%]  to:", Anchor::right);
    diagram.label({-0.15 * wide, (parts + 0.35) * high}, "from:", Anchor::right);
    for (int p = 0; p <= parts; ++p) {
        const double      top    = (parts - p) * high;
        const std::string column = name(p);
        const auto        space  = column.find(' ');
        diagram.label({(p + 0.5) * wide, (parts + (space == std::string::npos ? 0.5 : 0.95)) * high},
                      column.substr(0, space), Anchor::centre);
        if (space != std::string::npos)
            diagram.label({(p + 0.5) * wide, (parts + 0.35) * high}, column.substr(space + 1),
                          Anchor::centre);
        if (p == parts) continue;
        diagram.label({-0.15 * wide, top - high / 2}, name(p), Anchor::right);
        for (int q = 0; q <= parts; ++q) {
            const double percent = 100 * shares[std::size_t(p)][std::size_t(q)];
            diagram.polygon({{q * wide, top},
                             {(q + 1) * wide, top},
                             {(q + 1) * wide, top - high},
                             {q * wide, top - high}},
                            {q == parts ? Ink::vermilion : Ink::blue, Weight::thin},
                            std::clamp(percent / 60, 0.0, 1.0));
            diagram.label({(q + 0.5) * wide, top - high / 2}, fmt::format("{:.0f}", std::abs(percent)),
                          Anchor::centre);
        }
    }
}

/// The figures of the matrix.
inline void show_matrix(course::Chapter& chapter, const SolvedScene& box, const SolvedScene& aligned) {
    chapter.render(
        "matrix", "The form factors of the Cornell box",
        fmt::format("A row and a column for each of {} patches; lines between walls, lamp and blocks.",
                    box.patches.size()),
        matrix_picture(box));
    auto key = chapter.diagram("matrix_key", "What the matrix is of");
    draw_matrix_key(key, box);
    key.caption("A row and a column for each patch; a step of grey is a factor of 10.");
    auto diagram = chapter.diagram("parts", "From where to where light goes [%]");
    draw_parts(diagram, aligned);
    diagram.caption("Of the light leaving a row's surface, the share that arrives at the column's.");
    const auto shares = shares_between_parts(aligned);
    chapter.claim("8.7 of the tall block's light, there goes to the red wall [%]",
                  {25, 100 * shares[7][4], 0.5});
    chapter.claim("8.7 of the red wall's light, there goes to the tall block [%]",
                  {20, 100 * shares[4][7], 0.5});
    chapter.claim("8.7 of the floor's light, there leaves the box [%]", {15, 100 * shares[0][8], 0.5});
}

}  // namespace sr
