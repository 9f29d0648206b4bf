#pragma once
/// @file factor_claims.hpp
/// What sections 8.2 and 8.3 say of form factors, in numbers.

#include <cmath>
#include <map>
#include <string>

#include "course/chapter.hpp"
#include "factor_charts.hpp"
#include "radiosity/closed_form_factors.hpp"
#include "radiosity/point_form_factors.hpp"
#include "textbook_factors.hpp"
#include "unit_squares.hpp"

namespace sr {

/// Those that are known, to four digits.
inline void claim_form_factors(course::Chapter& chapter) {
    const auto claim = [&](const std::string& what, double expected, double measured) {
        chapter.claim("8.2 form factor of " + what,
                      {.expected = expected, .measured = measured, .tolerance = 5e-5});
    };
    const double opposed = opposed_rectangles(1, 1, 1), beside = perpendicular_rectangles(1, 1, 1);
    claim("opposite faces of a cube", 0.1998, opposed);
    claim("faces of a cube that share an edge", 0.2000, beside);
    claim("unit disks on one axis at the distance 1", 0.3820, coaxial_disks(1, 1, 1));
    chapter.claim("8.2 sum over the faces of a cube less 1",
                  {.expected = 0, .measured = opposed + 4 * beside - 1, .tolerance = 1e-14});
    chapter.claim("8.2 Hottel's formula in float, 100 sides apart",
                  {.expected = 0, .measured = double(textbook_opposed_squares(100.0F)), .tolerance = 0});
    chapter.claim("8.2 Hottel's formula in double, 10 000 sides apart",
                  {.expected = 0, .measured = textbook_opposed_squares(1e4), .tolerance = 0});
}

/// What a hemicube's eye sees of a patch that nothing hides, were its pixels of no size.
[[nodiscard]] inline double seen_from_the_middle(const Patch& from, const Patch& to) {
    return contour_form_factor(from.centre(), from.normal(), to);
}

/// What the charts show.
inline void claim_factor_races(course::Chapter& chapter, const std::map<std::string, FactorRace>& races) {
    const auto claim = [&](const std::string& what, double expected, double measured, double tolerance) {
        chapter.claim("8.3 " + what, {.expected = expected, .measured = measured, .tolerance = tolerance});
    };
    const auto power = [&](const std::string& pair, const std::string& method, double from) {
        return -races.at(pair).slope(method, from).value;
    };
    claim("opposed, contour: power of its points", 1, power("opposed", "contour", 16), 0.01);
    claim("touching, contour: power of its points", 1, power("touching", "contour", 16), 0.01);
    claim("opposed, points: power of the pairs", 0.5, power("opposed", "points", 16), 0.02);
    claim("touching, points: power of the pairs", 0.25, power("touching", "points", 16), 0.02);
    const auto error = [&](const std::string& pair, const std::string& method, double effort) {
        return 100 * races.at(pair).error(method, effort).value;
    };
    claim("opposed, hemicube: error of the finest [%]", 19.8, error("opposed", "hemicube", 49152), 0.05);
    claim("touching, seen from the middle with pixels of no size: too little by [%]", 4.95,
          100 * (1 -
                 seen_from_the_middle(level_square(), upright_square()) / perpendicular_rectangles(1, 1, 1)),
          0.005);
    claim("occluded, hemicube: error of the finest [%]", 100, error("occluded", "hemicube", 49152), 1e-9);
    claim("distant, hemicube: error of the coarsest, of 192 pixels [%]", 100,
          error("distant", "hemicube", 192), 1e-9);
    claim("distant, hemicube: error of the finest, of 49152 pixels [%]", 12,
          error("distant", "hemicube", 49152), 0.5);
    for (const std::string pair : {"opposed", "touching", "distant"})
        chapter.claim_at_most("8.3 " + pair + ", adaptive: relative error at a tolerance of 1e-7",
                              error(pair, "contour, adaptive", 1e7) / 100, 1e-7);
    const auto by_chance = [&](const std::string& pair, const std::string& method, double expected) {
        const auto measured = races.at(pair).error(method, 4096);
        claim(pair + ", " + method + ": error of 4096 [%]", expected, 100 * measured.value,
              400 * measured.se);
    };
    by_chance("touching", "random pairs", 8);
    by_chance("occluded", "random pairs", 1.5);
    by_chance("occluded", "contour and rays", 1.2);
    by_chance("occluded", "cosine rays", 2.2);
    by_chance("distant", "cosine rays", 25);
}

}  // namespace sr
