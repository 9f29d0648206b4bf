#pragma once
/// @file sampled_density.hpp
/// Does a sampler draw from the density it states? A domain is laid out on the unit square by a map, which is cut
/// into cells, and draws are counted there:
///     CHECK(chance_of_density(map_of_sphere, draw, pdf) > significance);
///     CHECK(chance_of_density(map_of_sphere, draw, another_pdf) < refused);
/// A map fits the domain, so that no cell is cut by the domain's rim:
///     at(s)    the point of the domain at s in the unit square
///     of(x)    the inverse
///     size(s)  the domain's measure (area, solid angle) per area of the unit square at s

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "math/gauss_legendre.hpp"
#include "math/vector.hpp"
#include "sampling/rng.hpp"
#include "statistics/tests.hpp"

namespace sr::test {

inline constexpr double significance = 1e-3;  ///< a right sampler's p lies above
inline constexpr double refused      = 1e-6;  ///< and a planted error's below

template <class At, class Of, class Size>
struct DomainMap {
    At   at;
    Of   of;
    Size size;
};

// Clang 16 does not deduce an aggregate's types by itself
template <class At, class Of, class Size>
DomainMap(At, Of, Size) -> DomainMap<At, Of, Size>;

/// A point of the unit square, x drawn before y.
template <class T>
[[nodiscard]] Vector2<T> square_point(Rng& rng) {
    const T x = rng.uniform<T>();
    return {x, rng.uniform<T>()};
}

inline constexpr int cells_a_side = 16;

[[nodiscard]] inline std::size_t cell_of(const Vector2<double>& s) {
    const auto along = [](double x) {
        return std::size_t(std::clamp(int(x * cells_a_side), 0, cells_a_side - 1));
    };
    return along(s.y) * std::size_t(cells_a_side) + along(s.x);
}

/// The integral of a density over each cell.
/// @param pdf  (point of the domain) -> double
template <class Map, class Density>
[[nodiscard]] std::vector<double> cell_probabilities(const Map& map, const Density& pdf) {
    constexpr double    side = 1.0 / cells_a_side;
    std::vector<double> cells;
    for (int row = 0; row < cells_a_side; ++row) {
        for (int column = 0; column < cells_a_side; ++column) {
            double sum = 0;
            for (const auto& [y, dy] : gauss_legendre(6, row * side, (row + 1) * side))
                for (const auto& [x, dx] : gauss_legendre(6, column * side, (column + 1) * side))
                    sum += dx * dy * map.size(Vector2<double>{x, y}) * pdf(map.at(Vector2<double>{x, y}));
            cells.push_back(sum);
        }
    }
    return cells;
}

template <class Map, class Density>
[[nodiscard]] double integral(const Map& map, const Density& pdf) {
    const auto cells = cell_probabilities(map, pdf);
    return std::accumulate(cells.begin(), cells.end(), 0.0);
}

/// How likely it is that draws come from that density: p of a chi-square test of 100 000.
/// @param draw  (Rng&) -> point of the domain
template <class Map, class Draw, class Density>
[[nodiscard]] double chance_of_density(const Map& map, const Draw& draw, const Density& pdf) {
    constexpr int draws    = 100'000;
    auto          expected = cell_probabilities(map, pdf);
    for (double& cell : expected) cell *= draws;
    std::vector<std::uint64_t> observed(expected.size());
    Rng                        rng{65, 0, 0, 0};
    for (int i = 0; i < draws; ++i) ++observed[cell_of(map.of(draw(rng)))];
    return chi_square_test(observed, expected).p;
}

}  // namespace sr::test
