/// @file draw_diagram.cpp

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>

#include "course/draw.hpp"
#include "course/gnuplot.hpp"

namespace sr::course {

namespace {

using Kind = Shape::Kind;

constexpr FontSize label_size = FontSize::diagram;
constexpr double   margin     = 16;   // around everything
constexpr double   tallest    = 560;  // a picture that still fits on a slide

/// The plane on the canvas: the same scale along x and y.
struct Plane {
    double scale = 1;   ///< units of the canvas for one of the plane
    Box    box   = {};  ///< of the plane, that the canvas shows
};

double label_width(const std::string& text) {
    return text_width(text, label_size);
}

/// What all shapes cover when a unit of the plane is `scale` on the canvas; a label's size does not change with it.
Box covered(const DiagramData& diagram, double scale) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Box              box{{infinity, infinity}, {-infinity, -infinity}};
    const auto       include = [&](Point min, Point max) {
        box.min = glm::min(box.min, min);
        box.max = glm::max(box.max, max);
    };
    for (const Shape& shape : diagram.shapes) {
        if (shape.kind == Kind::label) {
            const double width = label_width(shape.text) / scale;
            const double share = shape.anchor == Anchor::left ? 0 : shape.anchor == Anchor::centre ? 0.5 : 1;
            const Point  half{0, line_height(label_size) / 2 / scale};
            const Point  left = shape.points.front() - Point{share * width, 0};
            include(left - half, left + half + Point{width, 0});
        } else {
            for (const Point& p : shape.points) include(p, p);
        }
    }
    return box;
}

/// The largest scale at which all fits, found in a few steps since labels take more of the plane at a smaller one.
Plane fit(const DiagramData& diagram) {
    Plane plane{.box = covered(diagram, std::numeric_limits<double>::infinity())};
    for (int step = 0; step < 20; ++step) {
        const Point size = glm::max(plane.box.max - plane.box.min, Point{1e-9, 1e-9});
        plane.scale      = std::min((Canvas::width - 2 * margin) / size.x, (tallest - 2 * margin) / size.y);
        plane.box        = covered(diagram, plane.scale);
    }
    const Point centre = 0.5 * (plane.box.min + plane.box.max);
    const Point size   = plane.box.max - plane.box.min;
    const Point half{Canvas::width / plane.scale / 2, size.y / 2 + margin / plane.scale};
    plane.box = {centre - half, centre + half};
    return plane;
}

std::string stroke(const Pen& pen) {
    constexpr std::array widths{1.2, 2.2, 4.0};
    return fmt::format("dashtype {} linewidth {} linecolor rgb '{}'", pen.dashed ? 2 : 1,
                       widths[std::size_t(pen.weight)], hex(pen.ink));
}

/// A shape, drawn from its rows of the CSV. Without a title, or a browser would show the CSV's path over it.
std::string plot_of(const Shape& shape, const std::string& data) {
    switch (shape.kind) {
        case Kind::line:
            return fmt::format("{} using 3:4 notitle with lines {}", data, stroke(shape.pen));
        case Kind::arrow:
            return fmt::format("{} using 3:4:5:6 notitle with vectors head filled size screen 0.018,18 {}",
                               data, stroke(shape.pen));
        case Kind::area: {
            std::string border = fmt::format("{} using 3:4 notitle with lines {}", data, stroke(shape.pen));
            if (shape.opacity <= 0) return border;
            return fmt::format(
                "{} using 3:4 notitle with filledcurves closed fillcolor rgb '{}' fillstyle transparent "
                "solid "
                "{} noborder, {}",
                data, hex(shape.pen.ink), shape.opacity, border);
        }
        case Kind::point:
            return fmt::format("{} using 3:4 notitle with points pointtype 7 pointsize {} linecolor rgb '{}'",
                               data, shape.pen.weight == Weight::thin ? 0.5 : 0.9, hex(shape.pen.ink));
        case Kind::label:
            break;
    }
    return "";
}

std::string label_of(const Shape& shape, const Dialect& dialect) {
    constexpr std::array anchors{"left", "center", "right"};
    const Point          at = shape.points.front();
    return fmt::format("set label {} at {:.10g},{:.10g} {} front {} textcolor rgb '{}'\n",
                       dialect.text(shape.text), at.x, at.y, anchors[std::size_t(shape.anchor)],
                       dialect.font(label_size), hex(shape.pen.ink));
}

}  // namespace

std::string diagram_script(const DiagramData& diagram, const std::filesystem::path& csv,
                           std::string_view format) {
    if (diagram.shapes.empty())
        throw std::invalid_argument(fmt::format("diagram {}: nothing is drawn", diagram.name));
    const Plane   plane = fit(diagram);
    const Canvas  canvas{.height = (plane.box.max.y - plane.box.min.y) * plane.scale};
    const Dialect dialect{format};
    std::string   script =
        dialect.terminal(canvas) + "\n" +
        fmt::format(
            "set encoding utf8\nset datafile separator comma\nunset key\nunset border\nunset tics\n"
            "set margins 0,0,0,0\nset xrange [{:.10g}:{:.10g}]\nset yrange [{:.10g}:{:.10g}]\n",
            plane.box.min.x, plane.box.max.x, plane.box.min.y, plane.box.max.y);

    std::vector<std::string> plots;
    std::size_t              row = 0;
    for (const Shape& shape : diagram.shapes) {
        const std::size_t rows = shape.kind == Kind::arrow ? 1 : shape.points.size();
        const std::string data =
            fmt::format("{} skip 1 every ::{}::{}", gnuplot_string(csv.string()), row, row + rows - 1);
        if (shape.kind == Kind::label)
            script += label_of(shape, dialect);
        else
            plots.push_back(plot_of(shape, data));
        row += rows;
    }
    if (plots.empty()) plots.emplace_back("NaN notitle");  // only labels
    return script + fmt::format("plot {}\n", fmt::join(plots, ", "));
}

}  // namespace sr::course
