#pragma once
/// @file lamp_methods.hpp
/// Six ways to add up a lamp, and the chart of their errors against time.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "course/chapter.hpp"
#include "math/gauss_legendre.hpp"
#include "math/square.hpp"
#include "sampled.hpp"
#include "statistics/slope.hpp"

namespace sr {

/// A point of the unit square and how much it counts.
struct Node {
    Vector2<double> u;
    double          weight;
};

/// n^2 nodes: the middle of each cell, the points of a product of Gauss and Legendre's rules, or random ones, anywhere
/// or one in each cell.
enum class Rule { midpoint, gauss, random, stratified };

[[nodiscard]] inline std::vector<Node> nodes(Rule rule, int n, Rng& rng) {
    const auto        gauss = gauss_legendre(rule == Rule::gauss ? n : 1, 0, 1);
    std::vector<Node> all;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            if (rule == Rule::gauss) {
                const auto &x = gauss[std::size_t(i)], &y = gauss[std::size_t(j)];
                all.push_back({{x.x, y.x}, x.weight * y.weight});
                continue;
            }
            const Vector2<double> cell{i, j};
            const auto in_cell = rule == Rule::midpoint ? Vector2<double>{0.5, 0.5} : random_point(rng);
            all.push_back(
                {rule == Rule::random ? in_cell : (cell + in_cell) / double(n), 1 / square(double(n))});
        }
    }
    return all;
}

/// A rule, and whether it is applied to the lamp's area or to its solid angle.
struct LampMethod {
    std::string name;
    Rule        rule;
    bool        by_solid_angle;
};

inline const std::array<LampMethod, 6> lamp_methods{{{"midpoint", Rule::midpoint, false},
                                                     {"Gauss-Legendre", Rule::gauss, false},
                                                     {"area", Rule::random, false},
                                                     {"area, stratified", Rule::stratified, false},
                                                     {"solid angle", Rule::random, true},
                                                     {"solid angle, stratified", Rule::stratified, true}}};

/// Of many receivers: the root of the mean square of the relative errors, and its standard error.
struct LampError {
    double rms = 0, se = 0;
};

template <class Lamp>
[[nodiscard]] LampError lamp_error(const LampMethod& method, int n, const std::vector<Lamp>& lamps) {
    const bool by_chance = method.rule == Rule::random || method.rule == Rule::stratified;
    Rng        rng{7, n, 0, 0};
    auto       points = nodes(method.rule, n, rng);
    Running    squares;
    for (const auto& lamp : lamps) {
        if (by_chance) points = nodes(method.rule, n, rng);
        double sum = 0;
        for (const auto& [u, weight] : points)
            sum += weight * (method.by_solid_angle ? lamp.by_solid_angle(u) : lamp.by_area(u));
        squares.add(square(sum / lamp.exact() - 1));
    }
    const double rms = std::sqrt(squares.mean());
    return {rms, rms > 0 ? squares.standard_error() / (2 * rms) : 0};
}

/// What happens with one lamp: the errors of all methods for 2^2 to 64^2 nodes, timed on one thread, on a chart of
/// error against time; and the slopes of the errors against the number of nodes from 16^2 on.
class LampRace {
public:
    LampRace(course::Chart chart, std::string lamp, int repeats)
        : chart_(std::move(chart)), lamp_(std::move(lamp)), repeats_(repeats) {}

    [[nodiscard]] const std::string& lamp() const { return lamp_; }

    template <class Lamp>
    void run(const std::vector<Lamp>& lamps) {
        std::vector<course::Work> works;
        std::vector<LampError>    errors(lamp_methods.size() * sides.size());
        int                       all = 0;  // points for one receiver
        for (const int side : sides) all += int(lamp_methods.size()) * side * side * repeats_;
        course::Progress progress("adding up the " + lamp_, all);
        for (std::size_t m = 0; m < lamp_methods.size(); ++m) {
            for (std::size_t s = 0; s < sides.size(); ++s) {
                works.push_back({lamp_methods[m].name, [&, m, s] {
                                     errors[m * sides.size() + s] =
                                         lamp_error(lamp_methods[m], sides[s], lamps);
                                     progress.tick(sides[s] * sides[s]);
                                 }});
            }
        }
        const auto timings = course::measure(works, repeats_);
        for (std::size_t i = 0; i < works.size(); ++i) {
            const double n = square(double(sides[i % sides.size()]));
            chart_.row(
                {works[i].name, n, timings[i].seconds / double(lamps.size()), errors[i].rms, errors[i].se});
        }
        errors_ = errors;
    }

    [[nodiscard]] LampError error(std::size_t method, int n) const {
        const auto side = std::find(sides.begin(), sides.end(), n) - sides.begin();
        return errors_[method * sides.size() + std::size_t(side)];
    }

    [[nodiscard]] Slope slope(std::size_t method) const {
        std::vector<double> n, rms;
        for (const int side : {16, 23, 32, 45, 64}) {
            n.push_back(square(double(side)));
            rms.push_back(error(method, side).rms);
        }
        return log_log_slope(n, rms);
    }

private:
    static constexpr std::array sides{2, 3, 4, 6, 8, 11, 16, 23, 32, 45, 64};

    course::Chart          chart_;
    std::string            lamp_;
    int                    repeats_;
    std::vector<LampError> errors_;
};

}  // namespace sr
