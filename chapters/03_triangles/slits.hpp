#pragma once
/// @file slits.hpp
/// Section 3.4: the shares of rays that are lost, and how well they are known.

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "attack.hpp"
#include "course/chapter.hpp"
#include "leaks.hpp"
#include "math/extremes.hpp"

namespace sr {

// 40 000 rays at each mesh, whatever the quality: these numbers are in the text.
inline constexpr int attack_side = 200;

/// The rates of both meshes in the order of the text's table; and at vertices, of which the text names the first.
struct Expected {
    double cramer_float, cramer_double, planes_float, planes_double;
};

/// What attacks found.
struct Found {
    int    leaky          = 0;  ///< attacks in which a watertight test lost a ray
    double standard_error = 0;  ///< of the least known share [%]
};

/// Attacks the target in all places and precisions by all methods: a table, and the claims of what is in the text.
inline void slits(course::Chapter& chapter, const Target& target, At at,
                  const std::vector<Expected>& expected, Found& found) {
    const TileLoop loop{.threads = chapter.options().threads};
    const auto     aimed = aims(target, at, attack_side, loop);
    course::Rows   table{{"mesh", "rays at", "place", "precision", "Cramer [%]", "plane and edges [%]",
                          "as published [%]", "watertight [%]"}};
    const auto     what = at == At::edges ? "edges" : "vertices";
    for (std::size_t place = 0; place < placements.size(); ++place) {
        const auto in_float  = leak_rates<float>(target, placements[place], aimed, loop);
        const auto in_double = leak_rates<double>(target, placements[place], aimed, loop);
        for (const auto& [precision, rates] : {std::pair{"float", in_float}, {"double", in_double}}) {
            table.add({target.name, what, placements[place].name, precision, rates[0], rates[1], rates[2],
                       rates[3]});
            found.leaky += rates[2] == 0 && rates[3] == 0 ? 0 : 1;
            for (const double rate : rates)
                found.standard_error =
                    max_or_nan(found.standard_error, standard_error(rate, aimed.pixels().size()));
        }
        if (place >= expected.size()) continue;
        const auto claim = [&](const std::string& method, double rate, double measured) {
            chapter.claim(fmt::format("3.4 {}, {} {}: {}, rays lost [%]", target.name, what,
                                      placements[place].name, method),
                          {.expected = rate, .measured = measured, .tolerance = 0.05});
        };
        claim("Cramer, float", expected[place].cramer_float, in_float[0]);
        claim("Cramer, double", expected[place].cramer_double, in_double[0]);
        claim("plane, float", expected[place].planes_float, in_float[1]);
        claim("plane, double", expected[place].planes_double, in_double[1]);
    }
    chapter.say(table);
}

}  // namespace sr
