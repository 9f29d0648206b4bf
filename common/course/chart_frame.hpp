#pragma once
/// @file chart_frame.hpp
/// What of a chart is drawn where: its curves, the ranges of its axes, the place of every label. Units are those of
/// the canvas, y upwards from its lower left corner.

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "course/chart.hpp"
#include "course/label_layout.hpp"
#include "course/style.hpp"

namespace sr::course {

/// What is drawn at a point beside it: from `low` to `high`.
struct Bar {
    double x;
    double low;
    double high;
};

/// One curve: consecutive rows of the CSV.
struct Curve {
    std::string           name;
    Ink                   ink;
    std::size_t           first_row;
    std::size_t           last_row;
    Stroke                stroke;
    bool                  dashed   = false;
    std::vector<Bar>      bars     = {};
    std::optional<double> named_at = {};  ///< x of the point that its name stands by, if not its end
    std::vector<Point> points = {};  ///< what its axes can show: no gap, nothing negative where logarithmic
};

/// The curves that the axes can show, and those that they can't: of no point, or below 0 on a logarithmic axis.
struct Curves {
    std::vector<Curve> shown;
    std::string not_shown = {};  ///< the note on the others: "not shown: float (nowhere above 0)"; or empty
};

/// @throws std::invalid_argument naming the chart when no curve can be drawn
[[nodiscard]] Curves curves_of(const ChartData& chart, const Rows& grouped);

/// One axis: the values at its ends, and how they map to the canvas. A logarithmic axis that shows 0 too has its
/// place between min and `lowest`, the least of its numbers.
struct Scale {
    bool   log    = false;
    double min    = 0;
    double max    = 1;
    double from   = 0;  ///< where on the canvas min lies
    double to     = 1;  ///< and max
    double step   = 0;  ///< between the numbers along a linear axis
    double lowest = 0;  ///< 0: it shows no 0

    [[nodiscard]] bool   shows_zero() const { return lowest > 0; }
    [[nodiscard]] double zero() const { return std::sqrt(min * lowest); }  ///< drawn in its place
    [[nodiscard]] double operator()(double value) const;
};

/// A text of one or more lines: where its first line stands.
struct PlacedLabel {
    std::vector<std::string> lines;
    Ink                      ink;
    Point                    at;           ///< left end and middle of the first line
    std::vector<Point>       leader = {};  ///< from the curve's end, where the label does not stand at it
};

inline constexpr double below_plot = 74;  ///< what ticks and title of the x axis take

/// A chart laid out.
struct Frame {
    Canvas                   canvas;
    Scale                    x;
    Scale                    y;
    std::vector<std::string> title;
    std::vector<std::string> caption;  ///< and the note on curves that are not shown
    std::vector<PlacedLabel> labels;
};

[[nodiscard]] Frame lay_out(const ChartData& chart, const Curves& curves);

}  // namespace sr::course
