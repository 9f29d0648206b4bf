#pragma once
/// @file convergence_chart.hpp
/// Section 8.6: the whole method's error against patches and time, in the cube of mixed_cube.hpp.

#include <fmt/format.h>

#include <initializer_list>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "course/chapter.hpp"
#include "cube_points.hpp"
#include "statistics/slope.hpp"

namespace sr {

/// One curve of the chart.
struct CubeMethod {
    std::string name;
    Measured    measured;
    Within      within;
    int         finest;  ///< for its error to be several times the reference's
};

inline const std::vector<CubeMethod> cube_methods{
    {"constant", Measured::from_means, Within::constant, 12},
    {"interpolated", Measured::from_means, Within::interpolated, 12},
    {"constant, centres", Measured::from_centres, Within::constant, 16},
    {"interpolated, centres", Measured::from_centres, Within::interpolated, 16},
    {"gathered, centres", Measured::from_centres, Within::gathered, 6}};

/// The cube, solved with meshes of all sizes.
class CubeRace {
public:
    explicit CubeRace(const course::Options& options) : options_{options} {
        const bool       draft = options.quality == course::Quality::draft;
        course::Progress progress("solving the cube", 14);
        for (const int n : {1, 2, 3, 4, 6, 8, 12, 16}) {
            if (n <= (draft ? 8 : 12)) solve(n, Measured::from_means, n <= 4 ? 5 : draft || n > 8 ? 1 : 3);
            solve(n, Measured::from_centres, n <= 4 ? 5 : draft || n > 8 ? 1 : 3);
            progress.tick(n <= (draft ? 8 : 12) ? 2 : 1);
        }
        exact_ = reference_at(points_, at(8, Measured::from_centres), at(16, Measured::from_centres),
                              options.threads);
    }

    [[nodiscard]] const CubeSolution& at(int n, Measured measured) const {
        return solved_.at({n, measured}).first;
    }

    [[nodiscard]] bool has(int n, const CubeMethod& method) const {
        return n <= method.finest && solved_.contains({n, method.measured});
    }

    [[nodiscard]] Estimate error(int n, const CubeMethod& method, Part part = Part::everywhere) const {
        const auto values = values_at(points_, at(n, method.measured), method.within, options_.threads);
        return relative_rms(points_, values, exact_, part);
    }

    [[nodiscard]] double seconds(int n, Measured measured) const { return solved_.at({n, measured}).second; }

    /// The power of the number of patches with which a method's error falls, over some meshes.
    [[nodiscard]] Slope power(const CubeMethod& method, std::initializer_list<int> meshes,
                              Part part = Part::everywhere) const {
        std::vector<double> patches, errors;
        for (const int n : meshes) {
            if (!has(n, method)) continue;
            patches.push_back(6.0 * n * n);
            errors.push_back(error(n, method, part).value);
        }
        const Slope slope = log_log_slope(patches, errors);
        return {-slope.value, slope.standard_error};
    }

private:
    void solve(int n, Measured measured, int repeats) {
        CubeSolution cube;
        const auto   timing =
            course::measure({{"cube", [&] { cube = solve_mixed_cube(n, measured, 1); }}}, repeats);
        solved_[{n, measured}] = {std::move(cube), timing[0].seconds};
    }

    const course::Options&                                              options_;
    std::vector<CubePoint>                                              points_ = points_of_the_cube();
    std::map<std::pair<int, Measured>, std::pair<CubeSolution, double>> solved_;
    Values                                                              exact_;
};

inline void claim_means(course::Chapter& chapter, const CubeRace& race) {
    constexpr std::size_t face = 4;  // the floor, opposite the light
    for (const auto& [n, mean] : {std::pair{1, 0.1323}, {2, 0.1286}, {4, 0.128}, {8, 0.1279}})
        chapter.claim(fmt::format("8.6 the floor's mean, mean factors, {} x {} patches a face", n, n),
                      {mean, mean_of_face(race.at(n, Measured::from_means), face), 5e-5});
    for (const auto& [n, mean] :
         {std::pair{1, 0.15152}, {2, 0.13308}, {4, 0.12914}, {8, 0.12819}, {16, 0.12795}})
        chapter.claim(fmt::format("8.6 the floor's mean, factors of centres, {} x {} patches a face", n, n),
                      {mean, mean_of_face(race.at(n, Measured::from_centres), face), 5e-6});
    const double coarse = mean_of_face(race.at(8, Measured::from_centres), face),
                 fine   = mean_of_face(race.at(16, Measured::from_centres), face);
    chapter.claim("8.6 the floor's mean, extrapolated to no size",
                  {0.12787, fine + (fine - coarse) / 3, 5e-6});
}

inline void claim_power(course::Chapter& chapter, const std::string& of, const Slope& slope, double power,
                        double error) {
    const std::string what = "8.6 " + of + ": power with which the error falls";
    chapter.claim(what, {power, slope.value, 0.005});
    chapter.claim(what + ", standard error", {error, slope.standard_error, 0.005});
}

inline void claim_convergence(course::Chapter& chapter, const CubeRace& race) {
    course::Rows table{{"method", "power of the patches", "standard error"}};
    for (const auto& [method, power, error] : {std::tuple{0, 0.45, 0.01}, {1, 0.56, 0.02}, {4, 0.54, 0.01}}) {
        const auto& of    = cube_methods[std::size_t(method)];
        const Slope slope = race.power(of, {2, 3, 4, 6, 8});
        table.add({of.name, slope.value, slope.standard_error});
        claim_power(chapter, of.name, slope, power, error);
    }
    chapter.say(table);
    for (const auto& [n, constant, smooth, gathered] :
         {std::tuple{2, 7.5, 5.2, 1.07}, {4, 4.1, 2.6, 0.53}, {6, 2.8, 1.6, 0.33}}) {
        const auto claim = [&, pieces = n](std::size_t method, double percent, double digit) {
            const auto& of = cube_methods[method];
            chapter.claim(fmt::format("8.6 {}, {} x {} patches a face: error [%]", of.name, pieces, pieces),
                          {percent, 100 * race.error(pieces, of).value, digit / 2});
        };
        claim(0, constant, 0.1);
        claim(1, smooth, 0.1);
        claim(4, gathered, 0.01);
    }
}

/// The same in the room's corners and elsewhere: where the order is lost.
inline void chart_corners(course::Chapter& chapter, const CubeRace& race) {
    auto chart = chapter.chart(
        "corners", "The same cube: error in its corners and elsewhere",
        course::with_error(
            {.x = "patches", .y = "relative error, root mean square", .log = course::axis::xy}));
    struct Curve {
        std::size_t method;
        Part        part;
        std::string name;
        double      power, error;
    };
    for (const auto& [method, part, name, power, error] :
         {Curve{2, Part::near_corners, "constant, near corners", 0.45, 0.02},
          {2, Part::elsewhere, "constant, elsewhere", 0.51, 0.01},
          {2, Part::along_edges, "constant, along edges", 0.53, 0.02},
          {3, Part::near_corners, "interpolated, near corners", 0.44, 0.03},
          {3, Part::elsewhere, "interpolated, elsewhere", 1.09, 0.02},
          {3, Part::along_edges, "interpolated, along edges", 1.14, 0.04}}) {
        const auto& of = cube_methods[method];
        if (part != Part::along_edges)
            for (const int n : {2, 3, 4, 6, 8, 12, 16}) chart.add(name, 6 * n * n, race.error(n, of, part));
        claim_power(chapter, name, race.power(of, {4, 6, 8, 12, 16}, part), power, error);
    }
    chart.caption("Near is nearer than a quarter of an edge. As a share of the mean there.");
}

/// The figures of section 8.6.
inline void chart_convergence(course::Chapter& chapter) {
    const CubeRace race(chapter.options());
    auto           chart = chapter.chart("convergence", "A cube of six reflectances: error against time",
                                         {.x       = "time of form factors and solution [s]",
                                          .y       = "relative error of $B(\\mathbf{x})$, root mean square",
                                          .log     = course::axis::xy,
                                          .columns = course::speed_accuracy()});
    for (const auto& method : cube_methods) {
        for (const int n : {1, 2, 3, 4, 6, 8, 12, 16}) {
            if (!race.has(n, method)) continue;
            const Estimate error = race.error(n, method);
            chart.row({method.name, 6 * n * n, race.seconds(n, method.measured), error.value, error.error});
        }
    }
    chart.caption(
        "From 6 patches on, at 600 points, with standard errors. Gathering costs extra at each point.");
    claim_means(chapter, race);
    claim_convergence(chapter, race);
    chart_corners(chapter, race);
}

}  // namespace sr
