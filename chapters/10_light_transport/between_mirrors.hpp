#pragma once
/// @file between_mirrors.hpp
/// Section 10.6: two plates without an end, made of a box with four mirrors, and how their colours bleed.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "course/chapter.hpp"
#include "course/claims.hpp"
#include "known_charts.hpp"
#include "path_means.hpp"
#include "scene/small_scenes.hpp"
#include "transport/path_tracer.hpp"

namespace sr {

/// The upper plate shines with 1 and is grey.
struct Plates {
    static constexpr double         upper = 0.5;
    static constexpr DoubleSpectrum lower = {0.8, 0.5, 0.2};

    /// Of the lower one, by paths with so many diffuse bounces, an odd number.
    [[nodiscard]] static double term(double rho, int bounces) {
        return rho * std::pow(upper * rho, (bounces - 1) / 2);
    }
    [[nodiscard]] static double all(double rho) { return rho / (1 - upper * rho); }
};

/// The plates are the ends of a box whose sides are mirrors without a loss: who looks at a side sees the plates go on.
[[nodiscard]] inline Scene plates_between_mirrors() {
    const Material mirror{"mirror", LobeSum<float>{{{{1, 1, 1}, Mirror<float>{}}}}};
    Scene          scene;
    scene.materials = {mirror,
                       mirror,
                       mirror,
                       mirror,
                       diffuse_material("lower", convert<float>(Plates::lower)),
                       grey(float(Plates::upper), 1)};
    add_cube(scene, -1, 1);
    return scene;
}

/// What the lower plate sends to the eye by paths of 0, 1, 2, ... diffuse bounces, in red, green and blue.
[[nodiscard]] inline std::vector<Running> terms_between_mirrors(int most, int paths, int threads) {
    const PathTracer tracer(plates_between_mirrors());
    const Ray<float> ray{{0.2F, -0.1F, 0.3F}, {0.1F, 0.2F, -1}};
    return path_means(paths, 3 * (std::size_t(most) + 1), threads,
                      [&](RandomPoint& point, std::span<double> sums) {
                          PathCount count;
                          tracer.each_light(ray, point, count, [&](std::string_view way, Spectrum L) {
                              const auto bounces = std::size_t(std::ranges::count(way, 'D'));
                              if (bounces > std::size_t(most)) return;
                              sums[3 * bounces] += double(L.r);
                              sums[3 * bounces + 1] += double(L.g);
                              sums[3 * bounces + 2] += double(L.b);
                          });
                      });
}

inline void chart_plates_between_mirrors(course::Chapter& chapter) {
    constexpr int most  = 9;
    const auto    terms = terms_between_mirrors(most, 50'000, chapter.options().threads);
    auto          chart = chapter.chart(
                 "bleeding", "Two plates, diffuse bounce by diffuse bounce",
                 course::with_error(
                     {.x = "diffuse bounces", .y = "radiance they bring [W/(m$^2$ sr)]", .log = course::axis::y}));
    Worst            worst;
    const std::array channels{std::tuple{"red", Plates::lower.r, course::Ink::vermilion},
                              std::tuple{"green", Plates::lower.g, course::Ink::green},
                              std::tuple{"blue", Plates::lower.b, course::Ink::blue}};
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const auto& [name, rho, ink] = channels[channel];
        const std::string exact      = fmt::format("{}, exact", name);
        for (int k = 1; k <= most; k += 2) {
            const auto& L = terms[3 * std::size_t(k) + channel];
            chart.add(exact, k, Estimate{Plates::term(rho, k), 0});
            chart.add(name, k, worst.add(L, Plates::term(rho, k)));
        }
        chart.as_line(exact);
        chart.as_points(name);
        chart.in_ink(exact, ink);
        chart.in_ink(name, ink);
    }
    chart.caption(
        "Lines: exact. Dots: means of 50 000 paths; reflections in mirrors don't count as bounces.");
    worst.claim(chapter, "plates between mirrors");
    const course::Claims claim{chapter, "10.6"};
    for (const auto& [k, printed] : {std::pair{1, 0.8}, {3, 0.32}, {5, 0.128}}) {
        const auto& L = terms[3 * std::size_t(k)];
        claim(fmt::format("red by {} diffuse bounces", k), printed, L.mean(), 4 * L.standard_error());
    }
    claim("red by all, the plate reflecting 0.8, 0.5 and 0.2", 1.333, Plates::all(Plates::lower.r), 5e-4);
}

}  // namespace sr
