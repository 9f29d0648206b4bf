#pragma once
/// @file chart.hpp
/// A chart is a table of rows and the statement which column is drawn along which axis. The table is kept as
/// CSV, and gnuplot draws that file: the picture can't say anything else.

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "course/csv.hpp"
#include "course/style.hpp"
#include "statistics/estimate.hpp"

namespace sr::course {

/// Which axes are logarithmic.
enum class axis { none, x, y, xy };

/// The columns of a chart's CSV, and which of them are drawn.
struct Columns {
    std::vector<std::string> headers;  ///< all of them, in order
    std::string              series;   ///< rows of one text are a curve with that label; without, not drawn
    std::string              x;
    std::string              y;
    std::string              error = {};  ///< bars of y +- this: one standard error
    std::string              min   = {};  ///< or bars from min to max
    std::string              max   = {};
};

/// The columns of every speed/accuracy chart, `method,effort,seconds,error,error_se`, and what else it needs.
[[nodiscard]] Columns speed_accuracy(const std::vector<std::string>& more = {});

/// The axes of a chart. Titles are TeX with the unit: "distance [radii]", "$t$ [s]".
struct Axes {
    std::string x;
    std::string y;
    axis        log     = axis::none;
    Columns     columns = {};  ///< by default `series`, the title of x, the title of y
};

/// Axes of a chart of estimates: "standard error" is a column, and a bar of one stands at each point.
///     chapter.chart("lost", "Rays that are lost", with_error({.x = "radius", .y = "lost [%]"}))
[[nodiscard]] Axes with_error(Axes axes);

/// A vertical line with a name, such as where two curves cross; or a shaded band, up to `to`.
struct MarkedX {
    double                x;
    std::string           label;
    Ink                   ink = Ink::grey;
    std::optional<double> to  = {};
};

/// How a curve is drawn.
enum class Stroke { line_and_points, line, points };

/// Everything that a chart holds.
struct ChartData {
    std::string                   name;   ///< stem of its files
    std::string                   title;  ///< TeX
    Axes                          axes;
    Rows                          table    = {};
    std::string                   caption  = {};  ///< TeX; the claim that was measured
    std::vector<MarkedX>          marked   = {};
    std::map<std::string, Stroke> strokes  = {};
    std::map<std::string, Ink>    inks     = {};  ///< of curves that don't take theirs in turn
    std::set<std::string>         dashed   = {};
    std::map<std::string, double> named_at = {};  ///< of curves whose name does not belong to their end: x
};

/// Handle of a chart; copies fill the same chart.
class Chart {
public:
    Chart(std::string name, std::string title, Axes axes);

    /// One point of a curve; `more` fills the columns that are neither of the three, in their order.
    void add(std::string_view series, double x, double y, const std::vector<Cell>& more = {});

    /// One point with its bar, on axes with_error().
    void add(std::string_view series, double x, Estimate y) { add(series, x, y.value, {y.error}); }

    /// One row, a cell for each column.
    /// @throws std::invalid_argument naming chart, curve and x where a value that is drawn is not finite
    void row(std::vector<Cell> cells);

    /// Says that the curve has no value here: its line is interrupted, and the CSV holds "nan".
    void gap(std::string_view series, double x);

    /// The y of a curve where x is exactly this. @throws std::out_of_range when there is no such point
    [[nodiscard]] double at(std::string_view series, double x) const;

    void caption(std::string text) { data_->caption = std::move(text); }

    /// Draws a curve as a line without points: a closed form.
    void as_line(std::string series) { data_->strokes[std::move(series)] = Stroke::line; }
    /// Draws a curve as points without a line, with their bars: what is measured beside a closed form.
    void as_points(std::string series) { data_->strokes[std::move(series)] = Stroke::points; }

    /// Gives a curve its colour, the same on all charts that show it. Without it, the n-th curve has the n-th Ink.
    void in_ink(std::string series, Ink ink) { data_->inks[std::move(series)] = ink; }
    /// Dashes a curve's line: what belongs to another one of the same colour.
    void as_dashed(std::string series) { data_->dashed.insert(std::move(series)); }

    /// Puts a curve's name beside its point nearest this x, where its end lies in a crowd of others.
    void name_at(std::string series, double x) { data_->named_at[std::move(series)] = x; }

    void mark_x(double x, std::string label, Ink ink = Ink::grey) {
        data_->marked.push_back({x, std::move(label), ink});
    }
    /// Shades all between two x, with a name inside.
    void mark_band(double from, double to, std::string label) {
        data_->marked.push_back({from, std::move(label), Ink::grey, to});
    }

    [[nodiscard]] const ChartData& data() const { return *data_; }

    /// Whether no other handle is left that could fill it.
    [[nodiscard]] bool is_complete() const { return data_.use_count() == 1; }

private:
    std::shared_ptr<ChartData> data_;
};

/// The rows with each curve in one piece, in the order in which the curves began: what the CSV holds.
[[nodiscard]] Rows grouped_by_series(const ChartData& chart);

}  // namespace sr::course
