/// @file draw_chart.cpp

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "course/chart_frame.hpp"
#include "course/draw.hpp"
#include "course/gnuplot.hpp"
#include "course/number.hpp"

namespace sr::course {

namespace {

constexpr FontSize label_size = FontSize::normal;

/// A place on the canvas in gnuplot's words.
std::string screen(Point p, const Canvas& canvas) {
    return fmt::format("screen {:.5f}, screen {:.5f}", p.x / Canvas::width, p.y / canvas.height);
}

std::string text_at(const Dialect& dialect, const Canvas& canvas, const std::string& tex, Point at,
                    FontSize size, Ink ink) {
    return fmt::format("set label {} at {} left front {} textcolor rgb '{}'\n", dialect.text(tex),
                       screen(at, canvas), dialect.font(size), hex(ink));
}

/// Lines of text below each other; `at` is the left end and middle of the first.
std::string text_block(const Dialect& dialect, const Canvas& canvas, const std::vector<std::string>& lines,
                       Point at, FontSize size, Ink ink) {
    std::string script;
    for (const std::string& line : lines) {
        script += text_at(dialect, canvas, line, at, size, ink);
        at.y -= line_height(size);
    }
    return script;
}

/// The numbers along a logarithmic axis: powers of ten, of which eight or so are named, or decimals where it spans
/// less than three of those, also at 2 and 5 where they would be very few.
std::string log_ticks(char name, const Scale& scale, const Dialect& dialect) {
    const double             decades = std::log10(scale.max / scale.min);
    std::vector<std::string> major;
    std::vector<std::string> minor;
    const int                first = int(std::floor(std::log10(scale.min)));
    const int                last  = int(std::ceil(std::log10(scale.max)));
    const int                every =
        std::max(1, int(std::ceil(std::log10(scale.max / std::max(scale.min, scale.lowest)) / 8)));
    const bool plain = decades < 3 && scale.min >= 1e-4 && scale.max <= 1e6;  // as wide as fits
    for (int power = first; power <= last; ++power)
        for (int digit = 1; digit <= 9; ++digit) {
            const double value = digit * std::pow(10, power);
            const bool   named =
                (digit == 1 && power % every == 0) || (decades < 1.7 && (digit == 2 || digit == 5));
            if (value < std::max(scale.min, scale.lowest) * (1 - 1e-9) || value > scale.max * (1 + 1e-9))
                continue;
            const std::string label =
                plain ? (value < 1 ? fmt::format("{:.10g}", value) : whole(std::llround(value)))
                      : fmt::format("${}10^{{{}}}$", digit == 1 ? "" : fmt::format("{}\\cdot", digit), power);
            if (named)
                major.push_back(fmt::format("{} {:.10g}", dialect.text(label), value));
            else if (digit == 1 || every == 1)
                minor.push_back(fmt::format("'' {:.10g} 1", value));
        }
    if (scale.shows_zero()) major.push_back(fmt::format("'0' {:.10g}", scale.zero()));
    major.insert(major.end(), minor.begin(), minor.end());
    return fmt::format("set {}tics ({})\n", name, fmt::join(major, ", "));
}

std::string axis_of(char name, const Scale& scale, const Dialect& dialect) {
    const std::string script = fmt::format("set {}range [{:.10g}:{:.10g}]\n", name, scale.min, scale.max);
    if (!scale.log)
        return script + fmt::format("set {0}tics {1:.10g}\nset format {0} '%g'\n", name, scale.step);
    return script + fmt::format("set logscale {}\n", name) + log_ticks(name, scale, dialect);
}

std::string frame_of(const Frame& frame, const Dialect& dialect) {
    const Canvas& canvas = frame.canvas;
    return dialect.terminal(canvas) + "\n" +
           fmt::format(
               "set encoding utf8\nset datafile separator comma\nunset key\n"
               "set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\n"
               "set bmargin at screen {:.5f}\nset tmargin at screen {:.5f}\n",
               frame.x.from / Canvas::width, frame.x.to / Canvas::width, frame.y.from / canvas.height,
               frame.y.to / canvas.height) +
           fmt::format(
               "set border 3 linecolor rgb '{0}'\nset tics nomirror out scale 0.5, 0.25 textcolor rgb '{1}'\n"
               "set grid xtics ytics back linetype 1 linecolor rgb '#e0e0e0' linewidth 1, linetype 1 "
               "linecolor rgb '#f0f0f0' linewidth 1\n",
               hex(Ink::grey), hex(Ink::black)) +
           axis_of('x', frame.x, dialect) + axis_of('y', frame.y, dialect);
}

std::string texts_of(const ChartData& chart, const Frame& frame, const Dialect& dialect) {
    const Canvas& canvas = frame.canvas;
    const Point   title{12, canvas.height - 8 - line_height(FontSize::title) / 2};
    const Point   caption{12, frame.y.from - below_plot - line_height(FontSize::small) / 2 + 6};
    const Point   x_title{(frame.x.from + frame.x.to) / 2, frame.y.from - 50};
    const Point   y_title{14, (frame.y.from + frame.y.to) / 2};
    std::string   script = text_block(dialect, canvas, frame.title, title, FontSize::title, Ink::black) +
                         text_block(dialect, canvas, frame.caption, caption, FontSize::small, Ink::grey);
    script += fmt::format("set label {} at {} center {}\nset label {} at {} center rotate {}\n",
                          dialect.text(chart.axes.x), screen(x_title, canvas), dialect.font(label_size),
                          dialect.text(chart.axes.y), screen(y_title, canvas), dialect.font(label_size));
    for (const PlacedLabel& label : frame.labels) {
        script += text_block(dialect, canvas, label.lines, label.at, label_size, label.ink);
        if (!label.leader.empty())
            script += fmt::format("set arrow from {} to {} nohead back linewidth 1 linecolor rgb '{}'\n",
                                  screen(label.leader.front(), canvas), screen(label.leader.back(), canvas),
                                  hex(label.ink));
    }
    return script;
}

std::string mark_of(const MarkedX& mark) {
    if (mark.to)
        return fmt::format(
            "set object rectangle from first {:.10g}, graph 0 to first {:.10g}, graph 1 behind "
            "fillcolor rgb '#ececec' fillstyle solid noborder\n",
            mark.x, *mark.to);
    return fmt::format(
        "set arrow from first {0:.10g}, graph 0 to first {0:.10g}, graph 1 nohead back "
        "dashtype 2 linewidth 1.5 linecolor rgb '{1}'\n",
        mark.x, hex(mark.ink));
}

/// In gnuplot's words.
std::string_view words_of(Stroke stroke) {
    switch (stroke) {
        case Stroke::line:
            return "lines linewidth 2.5";
        case Stroke::points:
            return "points linewidth 2.5 pointtype 7 pointsize 0.6";
        case Stroke::line_and_points:
            return "linespoints linewidth 2.5 pointtype 7 pointsize 0.6";
    }
    throw std::logic_error{"a stroke that nobody drew"};
}

/// One curve, drawn from its rows of the CSV: its spread, then its line.
std::string plot_of(const ChartData& chart, const Curve& curve, const Frame& frame, const Dialect& dialect,
                    const std::string& csv) {
    const Columns& columns = chart.axes.columns;
    const auto     column  = [&](const std::string& name) { return 1 + chart.table.column(name); };
    const auto     x       = column(columns.x);
    const auto     y       = column(columns.y);
    const auto     data    = fmt::format("{} skip 1 every ::{}::{}", csv, curve.first_row, curve.last_row);

    const auto title =
        fmt::format("title {}", dialect.text(curve.name));  // what a browser shows over a curve

    std::string low;
    std::string high;
    if (!columns.error.empty()) {
        low  = fmt::format("${}-${}", y, column(columns.error));
        high = fmt::format("${}+${}", y, column(columns.error));
    } else if (!columns.min.empty() && !columns.max.empty()) {
        low  = fmt::format("${}", column(columns.min));
        high = fmt::format("${}", column(columns.max));
    }
    std::string plot;
    if (!low.empty()) {  // a bar that reaches to 0 or below leaves a logarithmic axis at its end
        const std::string from = fmt::format("(({0})>{1:.10g}?({0}):{1:.10g})", low, frame.y.min);
        const std::string line =
            fmt::format("vectors nohead linewidth 1.5 linecolor rgb '{}'", hex(curve.ink));
        plot = fmt::format("{} using {}:{}:(0):({}-{}) {} with {}, ", data, x, from, high, from, title, line);
    }
    const std::string height =
        frame.y.shows_zero() ? fmt::format("(${0}==0?{1:.10g}:${0})", y, frame.y.zero()) : std::to_string(y);
    return plot + fmt::format("{} using {}:{} {} with {} dashtype {} linecolor rgb '{}'", data, x, height,
                              title, words_of(curve.stroke), curve.dashed ? 2 : 1, hex(curve.ink));
}

}  // namespace

std::string chart_script(const ChartData& chart, const std::filesystem::path& csv, std::string_view format) {
    const Curves  curves = curves_of(chart, grouped_by_series(chart));
    const Frame   frame  = lay_out(chart, curves);
    const Dialect dialect{format};
    std::string   script = frame_of(frame, dialect) + texts_of(chart, frame, dialect);
    for (const MarkedX& mark : chart.marked) script += mark_of(mark);
    std::vector<std::string> plots;
    for (const Curve& curve : curves.shown)
        plots.push_back(plot_of(chart, curve, frame, dialect, gnuplot_string(csv.string())));
    return script + fmt::format("plot {}\n", fmt::join(plots, ", "));
}

}  // namespace sr::course
