/// @file chart_frame.cpp

#include "course/chart_frame.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>

namespace sr::course {

namespace {

constexpr FontSize label_size = FontSize::normal;
constexpr double   label_gap  = 12;                    // between a curve's end and its label
constexpr double   label_wrap = 0.24 * Canvas::width;  // a longer label takes two lines

bool is_log(const ChartData& chart, axis which) {
    return chart.axes.log == axis::xy || chart.axes.log == which;
}

/// The point of a curve that its name belongs to: that with the largest x, wherever it stands in the CSV, or the
/// nearest to where the chart wants it.
Point named_point(const Curve& curve) {
    return *std::ranges::min_element(curve.points, {}, [&](const Point& p) {
        return curve.named_at ? std::abs(p.x - *curve.named_at) : -p.x;
    });
}

/// The smallest and largest of some values.
struct Extent {
    double min = std::numeric_limits<double>::infinity();
    double max = -std::numeric_limits<double>::infinity();

    void include(double value, bool log) {
        if (!std::isfinite(value) || (log && value <= 0)) return;
        min = std::min(min, value);
        max = std::max(max, value);
    }
};

/// A round step: about a sixth of the range.
double round_step(double range) {
    const double raw   = range / 6;
    const double power = std::pow(10, std::floor(std::log10(raw)));
    for (const double step : {1.0, 2.0, 2.5, 5.0})
        if (raw <= step * power) return step * power;
    return 10 * power;
}

/// Of an axis in degrees: a divisor of the right angle, where there is one for so wide a range.
double step_of(const std::string& title, double range) {
    const bool degrees = title.ends_with("[deg]") || title.ends_with("[degrees]");
    if (degrees && range > 60)
        for (const double step : {15.0, 30.0, 45.0, 90.0})
            if (range <= 6 * step) return step;
    return round_step(range);
}

/// The ends of an axis that shows all of `extent`, and a little more or up to round numbers.
Scale scale_of(const std::string& title, Extent extent, bool log) {
    if (log) {
        const double decades = std::log10(extent.max / extent.min);
        const double margin  = std::pow(10, std::max(0.05 * decades, 0.04));
        return {.log = true, .min = extent.min / margin, .max = extent.max * margin};
    }
    if (extent.min > 0 && extent.min < 0.5 * extent.max)
        extent.min = 0;  // show how large, not only how different
    const double range =
        extent.max > extent.min ? extent.max - extent.min : std::max(1.0, std::abs(extent.max));
    const double step = step_of(title, range);
    // up to the next round number where that is near, and no farther than a point's width where it is not
    const double low  = std::floor(extent.min / step + 1e-9) * step;
    const double high = std::ceil(extent.max / step - 1e-9) * step;
    return {.min  = extent.min - low < 0.3 * step ? low : extent.min - 0.02 * range,
            .max  = high - extent.max < 0.3 * step ? high : extent.max + 0.02 * range,
            .step = step};
}

Extent y_extent(const ChartData& chart, const std::vector<Curve>& curves) {
    const bool log = is_log(chart, axis::y);
    Extent     extent;
    for (const Curve& curve : curves) {
        for (const Point& p : curve.points) extent.include(p.y, log);
        for (const Bar& bar : curve.bars) {
            extent.include(bar.high, log);
            // of y - error not on a logarithmic axis: it may be close to 0
            if (!log || chart.axes.columns.error.empty()) extent.include(bar.low, log);
        }
    }
    return extent;
}

/// The bar of a row, where there are bars.
std::optional<Bar> bar_of(const ChartData& chart, const std::vector<Cell>& row) {
    const Columns& columns = chart.axes.columns;
    const auto     value   = [&](const std::string& name) { return row[chart.table.column(name)].number(); };
    if (!columns.error.empty()) {
        const double y = value(columns.y), error = value(columns.error);
        return Bar{value(columns.x), y - error, y + error};
    }
    if (!columns.min.empty() && !columns.max.empty())
        return Bar{value(columns.x), value(columns.min), value(columns.max)};
    return {};
}

Extent x_extent(const ChartData& chart, const std::vector<Curve>& curves) {
    Extent extent;
    for (const Curve& curve : curves)
        for (const Point& p : curve.points) extent.include(p.x, is_log(chart, axis::x));
    for (const MarkedX& mark : chart.marked) {
        extent.include(mark.x, is_log(chart, axis::x));
        extent.include(mark.to.value_or(mark.x), is_log(chart, axis::x));
    }
    return extent;
}

/// Makes room for 0 below the numbers of a logarithmic axis.
Scale with_zero(Scale scale) {
    scale.lowest = scale.min;
    scale.min *= std::pow(scale.max / scale.min, -0.12);
    return scale;
}

bool has_zero(const std::vector<Curve>& curves) {
    return std::ranges::any_of(
        curves, [](const Curve& c) { return std::ranges::find(c.points, 0.0, &Point::y) != c.points.end(); });
}

bool has_positive(const std::vector<Curve>& curves) {
    return std::ranges::any_of(curves, [](const Curve& c) {
        return std::ranges::any_of(c.points, [](const Point& p) { return p.y > 0; });
    });
}

Stroke stroke_of(const ChartData& chart, const std::string& series) {
    const auto found = chart.strokes.find(series);
    return found == chart.strokes.end() ? Stroke::line_and_points : found->second;
}

Ink ink_of(const ChartData& chart, const std::string& series, std::size_t turn) {
    const auto found = chart.inks.find(series);
    return found == chart.inks.end() ? static_cast<Ink>(turn % inks) : found->second;
}

/// @throws std::invalid_argument where a curve was to be drawn in a way of its own, but has no row
void check_styles(const ChartData& chart, const std::vector<Curve>& all) {
    const auto check = [&](const std::string& series, const char* way) {
        if (std::ranges::find(all, series, &Curve::name) == all.end())
            throw std::invalid_argument(
                fmt::format("chart {}: no curve {} to draw {}", chart.name, series, way));
    };
    for (const auto& [series, stroke] : chart.strokes) check(series, "as a line or as points");
    for (const auto& [series, ink] : chart.inks) check(series, "in a colour of its own");
    for (const auto& series : chart.dashed) check(series, "dashed");
    for (const auto& [series, x] : chart.named_at) check(series, "with its name elsewhere");
}

/// In the words of the note under the chart, for a curve of which no point can be drawn.
std::string why_not_shown(const ChartData& chart, const Rows& grouped, const Curve& curve) {
    bool all_gaps = true;
    bool all_zero = is_log(chart, axis::y);
    for (std::size_t i = curve.first_row; i <= curve.last_row; ++i) {
        const Cell& y = grouped.rows[i][grouped.column(chart.axes.columns.y)];
        all_gaps      = all_gaps && !y.is_number();
        all_zero      = all_zero && (!y.is_number() || y.number() == 0);
    }
    if (all_gaps) return "nothing but gaps";
    return all_zero ? "0 everywhere" : "nowhere above 0";
}

/// A label's lines and the room that they take.
struct TextBlock {
    explicit TextBlock(const std::string& tex) : lines{wrapped(tex, label_size, label_wrap)} {
        for (const std::string& line : lines) width = std::max(width, text_width(line, label_size));
    }

    [[nodiscard]] double height() const { return double(lines.size()) * line_height(label_size); }
    [[nodiscard]] Box    at(Point left) const {
           return {{left.x, left.y - height() / 2}, {left.x + width, left.y + height() / 2}};
    }
    /// @param left  left end and middle of the block
    [[nodiscard]] PlacedLabel placed(Point left, Ink ink) const {
        return {lines, ink, {left.x, left.y + (height() - line_height(label_size)) / 2}};
    }

    std::vector<std::string> lines;
    double                   width = 0;
};

/// Finds a place for each label of a chart whose axes are laid out.
class Labeller {
public:
    Labeller(const Frame& frame, const std::vector<Curve>& curves) : frame_{frame} {
        for (const Curve& curve : curves) {
            std::vector<Point> line;
            for (const Point& p : curve.points) line.push_back(on_canvas(p));
            if (curve.stroke != Stroke::line)
                for (const Point& p : line) obstacles_.boxes.push_back({p - 5.0, p + 5.0});
            if (curve.stroke != Stroke::points) obstacles_.curves.push_back(std::move(line));
            for (const Bar& bar : curve.bars)
                obstacles_.curves.push_back(
                    {on_canvas({bar.x, std::max(bar.low, frame.y.min)}), on_canvas({bar.x, bar.high})});
        }
    }

    /// All lines first, so that no name stands on any.
    void at_marks(const std::vector<MarkedX>& marks) {
        for (const MarkedX& mark : marks)
            if (!mark.to)
                obstacles_.curves.push_back(
                    {{frame_.x(mark.x), frame_.y.from}, {frame_.x(mark.x), frame_.y.to}});
        for (const MarkedX& mark : marks) at_mark(mark);
    }

    void at_mark(const MarkedX& mark) {
        const TextBlock    block{mark.label};
        const double       x = frame_.x(mark.x);
        std::vector<Point> places;
        const double       half_line = line_height(label_size) / 2;  // below the topmost grid line
        for (double y = frame_.y.to - half_line - block.height() / 2; y > frame_.y.from; y -= half_line)
            if (mark.to)
                places.emplace_back((x + frame_.x(*mark.to) - block.width) / 2, y);
            else
                places.insert(places.end(), {{x + 6, y}, {x - 6 - block.width, y}});
        const auto covered = [&](Point left) { return cost(block.at(left)); };
        put(block, *std::ranges::min_element(places, {}, covered), mark.ink);
    }

    // Where the label of a curve may stand; of each, whether it covers nothing there, and is placed.

    [[nodiscard]] bool right_of_end(const Curve& curve) {
        return put_first_free({on_canvas(named_point(curve)) + Point{label_gap, 0}}, curve);
    }

    /// Beside a point within half of the curve's width from the named one, the nearer the better.
    [[nodiscard]] bool beside(const Curve& curve) {
        const TextBlock    block{curve.name};
        const double       up = block.height() / 2 + 8;
        std::vector<Point> places;
        std::vector<Point> points;
        for (const Point& p : curve.points) points.push_back(on_canvas(p));
        const auto [left, right] = std::ranges::minmax(points, {}, &Point::x);
        const auto distance      = [named = on_canvas(named_point(curve)).x](const Point& p) {
            return std::abs(p.x - named);
        };
        std::ranges::sort(points, {}, distance);
        for (const Point& p : points) {
            if (distance(p) > (right.x - left.x) / 2) break;
            for (const Point& shift : {Point{label_gap, 0},
                                       {8, up},
                                       {8, -up},
                                       {-block.width / 2, up + 4},
                                       {-block.width / 2, -up - 4},
                                       {-block.width - 8, up},
                                       {-block.width - 8, -up}})
                places.push_back(p + shift);
        }
        return put_first_free(places, curve);
    }

    /// Farther from the curve's end, with a leader that crosses nothing.
    [[nodiscard]] bool around_end(const Curve& curve) {
        const TextBlock block{curve.name};
        const Point     end = on_canvas(named_point(curve));
        for (double distance = 25; distance <= 100; distance += 15)
            for (int twelfth = 0; twelfth < 12; ++twelfth) {  // of a turn, from straight up
                const double angle = twelfth * std::numbers::pi / 6;
                const Point  towards{std::sin(angle), std::cos(angle)};
                const Point  side = end + distance * towards;  // the middle of the label's near side
                const Point  left = towards.x < 0 ? side - Point{block.width, 0} : side;
                const std::vector<Point> leader{end + 8.0 * towards, side - 3.0 * towards};
                if (cost(block.at(left)) > 0 || crosses(leader)) continue;
                put(block, left, curve.ink);
                labels.back().leader = leader;
                obstacles_.curves.push_back(leader);
                return true;
            }
        return false;
    }

    /// In the right margin, as near as there is room to the heights at which the curves end.
    void in_margin(const std::vector<const Curve*>& curves) {
        std::vector<double> ends;
        std::vector<double> sizes;
        for (const Curve* curve : curves) {
            ends.push_back(on_canvas(named_point(*curve)).y);
            sizes.push_back(TextBlock{curve->name}.height());
        }
        const std::vector<double> heights = spread(ends, sizes, frame_.y.from, frame_.y.to);
        for (std::size_t i = 0; i < curves.size(); ++i) {
            const TextBlock block{curves[i]->name};
            const Point     end   = on_canvas(named_point(*curves[i]));
            const Point     left  = {frame_.x.to + label_gap, heights[i]};
            PlacedLabel     label = block.placed(left, curves[i]->ink);
            if (std::abs(left.y - end.y) > 6 || left.x - end.x > 3 * label_gap) {
                label.leader = {end + Point{7, 0}, left - Point{3, 0}};
                obstacles_.curves.push_back(label.leader);
            }
            labels.push_back(label);
            obstacles_.boxes.push_back(block.at(left));
        }
    }

    std::vector<PlacedLabel> labels;

private:
    [[nodiscard]] Point on_canvas(Point value) const { return {frame_.x(value.x), frame_.y(value.y)}; }

    /// How much a label covers; more than all else counts what is not on the canvas.
    [[nodiscard]] int cost(const Box& box) const {
        const bool inside = box.min.x >= frame_.x.from && box.max.x <= Canvas::width - 4 &&
                            box.min.y >= frame_.y.from && box.max.y <= frame_.y.to + 4;
        return obstacles_.covered_by(box) + (inside ? 0 : 1000);
    }

    [[nodiscard]] bool put_first_free(const std::vector<Point>& places, const Curve& curve) {
        const TextBlock block{curve.name};
        const auto free = std::ranges::find_if(places, [&](Point left) { return cost(block.at(left)) == 0; });
        if (free == places.end()) return false;
        put(block, *free, curve.ink);
        return true;
    }

    /// Looked at every other unit of its length.
    [[nodiscard]] bool crosses(const std::vector<Point>& leader) const {
        const Point  along = leader.back() - leader.front();
        const double steps = glm::length(along) / 2;
        for (double i = 0; i <= steps; ++i) {
            const Point p = leader.front() + i / steps * along;
            if (obstacles_.covered_by({p - 1.0, p + 1.0}) > 0) return true;
        }
        return false;
    }

    void put(const TextBlock& block, Point left, Ink ink) {
        labels.push_back(block.placed(left, ink));
        obstacles_.boxes.push_back(block.at(left));
    }

    const Frame& frame_;
    Obstacles    obstacles_;
};

/// A curve that ends near the right edge has its label in the margin, which is as wide as that needs, and so has one
/// beside which there is no room.
void place_labels(Frame& frame, const ChartData& chart, const std::vector<Curve>& curves) {
    std::vector<const Curve*> in_margin;
    std::vector<const Curve*> inside;
    frame.x.to = Canvas::width;
    for (const Curve& curve : curves) {
        const bool at_edge =
            frame.x(named_point(curve).x) > frame.x.from + 0.85 * (frame.x.to - frame.x.from);
        (at_edge ? in_margin : inside).push_back(&curve);
    }
    for (;;) {
        double widest = 0;
        for (const Curve* curve : in_margin) widest = std::max(widest, TextBlock{curve->name}.width);
        frame.x.to = Canvas::width - (widest > 0 ? widest + 1.5 * label_gap : 24);
        Labeller labeller{frame, curves};
        labeller.in_margin(in_margin);
        labeller.at_marks(chart.marked);
        std::vector<const Curve*> waiting = inside;  // for those that take the best places first
        for (const auto place : {&Labeller::right_of_end, &Labeller::beside, &Labeller::around_end})
            std::erase_if(waiting, [&](const Curve* curve) { return (labeller.*place)(*curve); });
        frame.labels = labeller.labels;
        if (waiting.empty()) return;
        in_margin.push_back(waiting.front());
        std::erase(inside, waiting.front());
    }
}

}  // namespace

double Scale::operator()(double value) const {
    if (log && shows_zero() && value == 0) value = zero();
    const double share = log ? std::log(value / min) / std::log(max / min) : (value - min) / (max - min);
    return from + share * (to - from);
}

Curves curves_of(const ChartData& chart, const Rows& grouped) {
    const std::size_t  series = grouped.column(chart.axes.columns.series);
    const std::size_t  x      = grouped.column(chart.axes.columns.x);
    const std::size_t  y      = grouped.column(chart.axes.columns.y);
    std::vector<Curve> all;
    for (std::size_t i = 0; i < grouped.rows.size(); ++i) {
        const auto&        row  = grouped.rows[i];
        const std::string& name = row[series].text();
        if (name.empty()) continue;
        if (all.empty() || all.back().name != name)
            all.push_back({name, ink_of(chart, name, all.size()), i, i, stroke_of(chart, name),
                           chart.dashed.contains(name)});
        all.back().last_row = i;
        if (const auto found = chart.named_at.find(name); found != chart.named_at.end())
            all.back().named_at = found->second;
        const Point p{row[x].number(), row[y].number()};
        const bool  gap = !row[y].is_number();
        const bool  shown =
            !gap && (p.x > 0 || !is_log(chart, axis::x)) && (p.y >= 0 || !is_log(chart, axis::y));
        if (!shown) continue;
        all.back().points.push_back(p);
        if (const auto bar = bar_of(chart, row)) all.back().bars.push_back(*bar);
    }
    if (all.empty()) throw std::invalid_argument(fmt::format("chart {}: it has no rows", chart.name));
    check_styles(chart, all);

    if (is_log(chart, axis::y) && !has_positive(all)) {  // 0 has no place where no other number gives one
        for (Curve& curve : all) curve.points.clear();
    }
    Curves curves;
    for (Curve& curve : all)
        if (curve.points.empty())
            curves.not_shown += (curves.not_shown.empty() ? "not shown: " : "; ") + curve.name + " (" +
                                why_not_shown(chart, grouped, curve) + ")";
        else
            curves.shown.push_back(std::move(curve));
    if (curves.shown.empty())
        throw std::invalid_argument(fmt::format(
            "chart {}: nothing can be drawn on its axes; {}; a logarithmic axis needs a value above 0",
            chart.name, curves.not_shown));
    return curves;
}

Frame lay_out(const ChartData& chart, const Curves& all) {
    const std::vector<Curve>& curves = all.shown;
    Frame                     frame;
    frame.title = wrapped(chart.title, FontSize::title, 0.95 * Canvas::width);
    for (const std::string& text : {chart.caption, all.not_shown}) {
        if (text.empty()) continue;
        const std::vector<std::string> lines = wrapped(text, FontSize::small, 0.95 * Canvas::width);
        frame.caption.insert(frame.caption.end(), lines.begin(), lines.end());
    }
    const double title   = double(frame.title.size()) * line_height(FontSize::title);
    const double caption = double(frame.caption.size()) * line_height(FontSize::small);
    frame.canvas.height += caption;
    frame.x = scale_of(chart.axes.x, x_extent(chart, curves), is_log(chart, axis::x));
    frame.y = scale_of(chart.axes.y, y_extent(chart, curves), is_log(chart, axis::y));
    if (frame.y.log && has_zero(curves)) frame.y = with_zero(frame.y);

    frame.x.from = 88;
    frame.y.from = below_plot + caption;
    frame.y.to   = frame.canvas.height - title - 22;
    place_labels(frame, chart, curves);
    return frame;
}

}  // namespace sr::course
