#pragma once
/// @file furnace.hpp
/// Spheres in a uniform sky: where a sphere gives back all light, it can't be seen; where it glows, it makes some.

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "course/chapter.hpp"
#include "cures.hpp"
#include "material/phong_albedo.hpp"
#include "reflected.hpp"
#include "transport/tiles.hpp"

namespace sr {

/// What a material gives back at angles of 0 to 90 degrees; between them, by lines.
class AlbedoTable {
public:
    /// @param at  (theta in degrees) -> albedo
    explicit AlbedoTable(const std::function<double(double)>& at) {
        for (int theta = 0; theta < 90; ++theta) values_.push_back(at(theta));
        values_.push_back(at(89.9));
    }

    /// @param cosine  of the angle, 0 to 1
    [[nodiscard]] double operator()(double cosine) const {
        const double theta = std::min(degrees(std::acos(cosine)), 89.999);
        const auto   i     = std::size_t(theta);
        return values_[i] + (theta - double(i)) * (values_[i + 1] - values_[i]);
    }

private:
    std::vector<double> values_;
};

/// The row of section 6.6, from left to right.
[[nodiscard]] inline std::vector<AlbedoTable> furnace_row() {
    const auto phong = [](double e, PhongScale scale) {
        const double c = Phong<double>(e, scale).f({0, 0, 1}, {0, 0, 1});
        return AlbedoTable([=](double theta) { return c * phong_albedo(e, radians(theta)); });
    };
    const HemisphereRule  rule = hemisphere_rule(64);
    const DividedByLarger larger{Phong{10.0}};
    return {AlbedoTable([](double) { return 1; }), phong(1, PhongScale::none), phong(10, PhongScale::density),
            phong(10, PhongScale::albedo),
            AlbedoTable([&](double theta) { return albedo(larger, at_angle(theta), rule); })};
}

/// Seen from afar, so that a point at the distance r from a sphere's middle is seen under sin(theta) = r.
inline void render_furnace(course::Chapter& chapter) {
    const auto      row    = furnace_row();
    const int       height = 2 * chapter.options().size / int(row.size());
    Image<Spectrum> film(height * int(row.size()), height);
    constexpr int   side = 4;
    constexpr float sky  = 0.45F;
    for_each_pixel(film.width(), height, {.threads = chapter.options().threads}, [&](int x, int y) {
        double sum = 0;
        for (int part = 0; part < side * side; ++part) {
            const int    column = part % side, line = part / side;
            const double u       = 2.3 * ((x % height + (column + 0.5) / side) / height - 0.5);
            const double v       = 2.3 * ((y + (line + 0.5) / side) / height - 0.5);
            const double squared = u * u + v * v;
            sum += squared < 1 ? row[std::size_t(x / height)](std::sqrt(1 - squared)) : 1;
        }
        const float L = sky * float(sum / (side * side));
        film(x, y)    = {L, L, L};
    });
    chapter.render(
        "furnace", "Spheres in a uniform sky",
        "Diffuse; Phong's lobe as it is, $e = 1$; $e = 10$ with $(e+1)/2\\pi$, with $(e+2)/2\\pi$, and "
        "divided by the larger cosine.",
        film);
}

}  // namespace sr
