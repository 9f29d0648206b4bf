#include "course/chart.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <stdexcept>

#include "child.hpp"
#include "course/chart_frame.hpp"
#include "course/draw.hpp"
#include "course/gnuplot.hpp"
#include "course/label_layout.hpp"
#include "scratch_folder.hpp"

using namespace sr;
using namespace sr::course;

namespace {

/// By more than rounding: a label may stand on the one below.
bool overlap(const Box& a, const Box& b) {
    constexpr double touch = 1e-6;
    return a.min.x + touch < b.max.x && b.min.x + touch < a.max.x && a.min.y + touch < b.max.y &&
           b.min.y + touch < a.max.y;
}

Box box_of(const PlacedLabel& label) {
    double width = 0;
    for (const std::string& line : label.lines) width = std::max(width, text_width(line, FontSize::normal));
    const double line = line_height(FontSize::normal);
    const double rest = double(label.lines.size()) - 1;
    return {{label.at.x, label.at.y - (rest + 0.5) * line}, {label.at.x + width, label.at.y + 0.5 * line}};
}

/// Curves that end at nearly one point, and one that ends early.
Chart crowded() {
    Chart chart{"crowded",
                "Title of $x^2$",
                {.x = "time [s]", .y = "error [1]", .log = axis::xy, .columns = speed_accuracy({"note"})}};
    for (int i = 0; i < 6; ++i)
        for (int curve = 0; curve < 5; ++curve) {
            const double n = std::pow(10, i);
            if (curve < 4 || i < 3)
                chart.row({"method_" + std::to_string(curve), n, 1e-6 * n, (1 + 0.01 * curve) / std::sqrt(n),
                           2 / std::sqrt(n), "a,b"});
        }
    chart.caption("Slope $-1/2$ & more");
    chart.mark_x(1e-3, "crossover");
    return chart;
}

Frame laid_out(const Chart& chart) {
    return lay_out(chart.data(), curves_of(chart.data(), grouped_by_series(chart.data())));
}

/// The labels of a chart, of which none leaves the canvas or covers another one, a curve or its bars.
std::vector<PlacedLabel> readable_labels(const Chart& chart) {
    const Frame frame = laid_out(chart);
    Obstacles   drawn;
    for (const Curve& curve : curves_of(chart.data(), grouped_by_series(chart.data())).shown) {
        auto& line = drawn.curves.emplace_back();
        for (const Point& p : curve.points) line.emplace_back(frame.x(p.x), frame.y(p.y));
        for (const Bar& bar : curve.bars)
            drawn.curves.push_back({{frame.x(bar.x), frame.y(std::max(bar.low, frame.y.min))},
                                    {frame.x(bar.x), frame.y(bar.high)}});
    }
    for (std::size_t i = 0; i < frame.labels.size(); ++i) {
        const Box box = box_of(frame.labels[i]);
        CHECK(drawn.covered_by(box) == 0);
        CHECK(box.min.x >= 0);
        CHECK(box.max.x <= Canvas::width);
        for (std::size_t j = 0; j < i; ++j) CHECK(!overlap(box, box_of(frame.labels[j])));
    }
    return frame.labels;
}

}  // namespace

TEST_CASE("a chart keeps what it is given, under the headers it was given") {
    Chart chart{"c", "t", {.x = "distance [radii]", .y = "wrong [%]"}};
    chart.add("textbook", 10, 2.5);
    chart.add("cured", 10, 0.5);
    chart.add("textbook", 100, 3.5);
    CHECK(chart.at("textbook", 100) == 3.5);
    CHECK_THROWS_WITH_AS((void)chart.at("cured", 7), "chart c: nothing of cured at distance [radii] = 7",
                         std::out_of_range);
    // each curve in one piece, so that gnuplot finds it by its rows
    CHECK(to_csv(grouped_by_series(chart.data())) ==
          "series,distance [radii],wrong [%]\ntextbook,10,2.5\ntextbook,100,3.5\ncured,10,0.5\n");
}

TEST_CASE("a speed/accuracy chart has the columns of all of them") {
    Chart chart{"c", "t", {.x = "time [s]", .y = "error", .columns = speed_accuracy({"pixels"})}};
    chart.add("uniform", 0.5, 0.25, {64, 0.125, 512});
    CHECK(to_csv(chart.data().table) ==
          "method,effort,seconds,error,error_se,pixels\nuniform,64,0.5,0.25,0.125,512\n");
    CHECK_THROWS_AS(chart.add("uniform", 0.5, 0.25), std::invalid_argument);
    CHECK_THROWS_AS(
        (Chart{"c",
               "t",
               {.x = "", .y = "", .columns = {.headers = {"a", "b"}, .series = "a", .x = "b", .y = "c"}}}),
        std::invalid_argument);
}

TEST_CASE("a chart of estimates keeps their errors and draws them as bars") {
    Chart chart{"c", "t", with_error({.x = "radius", .y = "lost [%]", .log = axis::x})};
    chart.add("float", 0.5, Estimate{.value = 3, .error = 0.25});
    chart.add("double", 0.5, 0, {0});
    CHECK(to_csv(chart.data().table) ==
          "series,radius,lost [%],standard error\nfloat,0.5,3,0.25\ndouble,0.5,0,0\n");
    CHECK(chart.data().axes.log == axis::x);
    CHECK(chart_script(chart.data(), "c.csv", "svg").find("($3-$4)") != std::string::npos);
    CHECK_THROWS_AS(chart.add("float", 1, 2), std::invalid_argument);
}

TEST_CASE("labels cover neither each other nor a curve, and stay on the canvas") {
    CHECK(readable_labels(crowded()).size() == 6);
}

TEST_CASE("a label that would cover another curve stands apart, with a leader to its own") {
    Chart      chart{"c", "t", with_error({.x = "time [ns]", .y = "wrong [%]", .log = axis::xy})};
    const auto add = [&](const std::string& method, const std::vector<Point>& points) {
        for (const Point& p : points) chart.add(method, p.x, Estimate{p.y, 0.006});
    };
    add("fixed steps", {{193, 17}, {215, 0.4}, {325, 0}, {480, 0}});
    add("isolated roots", {{553, 0}});
    add("sphere tracing", {{315, 9}, {1560, 0.006}});
    add("segment tracing", {{1785, 0.08}, {2070, 0}, {2270, 0}});
    add("intervals", {{3200, 11}, {4500, 0}});
    const auto labels = readable_labels(chart);
    REQUIRE(labels.size() == 5);
    CHECK(std::ranges::count_if(labels, [](const PlacedLabel& label) { return !label.leader.empty(); }) >= 2);
    for (const PlacedLabel& label : labels) {
        if (label.leader.empty()) continue;
        for (const PlacedLabel& other : labels)
            CHECK(Obstacles{.curves = {label.leader}}.covered_by(box_of(other)) == 0);
    }
}

TEST_CASE("a curve's name stands beside the point that it is wanted at, and at its end otherwise") {
    const auto x_of_name = [](auto wanted) {
        Chart chart{"c", "t", {.x = "x", .y = "y"}};
        for (int i = 0; i <= 10; ++i) {
            chart.add("high", i, 10 - i);
            chart.add("low", i, 0);
        }
        wanted(chart);
        const auto labels = readable_labels(chart);
        const auto found  = std::ranges::find(labels, std::vector<std::string>{"high"}, &PlacedLabel::lines);
        REQUIRE(found != labels.end());
        const Frame frame = lay_out(chart.data(), curves_of(chart.data(), grouped_by_series(chart.data())));
        return (found->at.x - frame.x.from) / (frame.x.to - frame.x.from);
    };
    CHECK(x_of_name([](Chart&) {}) > 1);
    const double wanted = x_of_name([](Chart& chart) { chart.name_at("high", 2.9); });
    CHECK(wanted > 0.25);
    CHECK(wanted < 0.4);
    CHECK_THROWS_AS(x_of_name([](Chart& chart) { chart.name_at("no such curve", 2.9); }),
                    std::invalid_argument);
}

TEST_CASE("a label does not stand on a bar of the next curve") {
    Chart chart{"c", "t", with_error({.x = "x", .y = "y"})};
    chart.add("first", 1, 0, {0});
    chart.add("first", 2, 1, {0});
    chart.add("second", 2.4, 1, {1});
    chart.add("third", 8, 1, {1});
    CHECK(readable_labels(chart).size() == 3);
}

TEST_CASE("axes show all of the data and not much more") {
    const std::pair<double, double> extents[] = {{0, 61.4},      {0, 60}, {-1, 1},   {0.37, 0.41},
                                                 {1e5, 1e5 + 3}, {7, 7},  {-3, -2.9}};
    for (const auto& [low, high] : extents) {
        Chart chart{"c", "t", {.x = "x", .y = "y"}};
        chart.add("a", low, high);
        chart.add("a", high, low);
        const Frame frame = laid_out(chart);
        for (const Scale& scale : {frame.x, frame.y}) {
            CHECK(scale.min <= low);
            CHECK(scale.max >= high);
            CHECK(scale.max > scale.min);
            CHECK(scale.max - scale.min <= std::max({2 * (high - low), std::abs(high), 1.0}) * 1.6);
        }
    }
}

TEST_CASE("an axis in degrees has a tick at the right angle") {
    const auto step = [](double from, double to, const std::string& unit) {
        Chart chart{"c", "t", {.x = "angle [" + unit + "]", .y = "y"}};
        chart.add("a", from, 0);
        chart.add("a", to, 1);
        return laid_out(chart).x.step;
    };
    CHECK(step(0, 90, "deg") == 15);
    CHECK(step(-90, 90, "degrees") == 30);
    CHECK(step(0, 360, "deg") == 90);
    CHECK(step(0, 60, "deg") == 10);
    CHECK(step(40, 42, "deg") == 0.5);
    CHECK(step(0, 90, "m") == 20);
    CHECK(step(0, 3600, "deg") == 1000);
}

TEST_CASE("spread labels are apart, in order, and no farther moved than they must be") {
    const std::vector<double> far{10, 50, 90};
    CHECK(spread(far, {20, 20, 20}, 0, 100) == far);
    CHECK(spread({50, 50, 50}, {20, 20, 20}, 0, 100) == std::vector<double>{30, 50, 70});
    CHECK(spread({1, 0}, {20, 20}, 0, 100) == std::vector<double>{30, 10});
    CHECK(spread({95, 95}, {20, 30}, 0, 100) == std::vector<double>{60, 85});
}

TEST_CASE("a box is covered by what crosses it and not by what passes") {
    const Obstacles line{.curves = {{{0, 0}, {10, 10}}}};
    CHECK(line.covered_by({{4, 4}, {6, 6}}) == 1);
    CHECK(line.covered_by({{4, 6}, {5, 9}}) == 0);
    CHECK(line.covered_by({{11, 11}, {12, 12}}) == 0);
}

TEST_CASE("what no axis can show is told with chart and curve") {
    Chart chart{"c", "t", {.x = "x", .y = "y", .log = axis::y}};
    CHECK_THROWS_WITH((void)laid_out(chart), "chart c: it has no rows");
    CHECK_NOTHROW(chart.add("good", 1, 1));
    constexpr double infinity = std::numeric_limits<double>::infinity();
    CHECK_THROWS_WITH_AS(chart.add("good", 2, std::numeric_limits<double>::quiet_NaN()),
                         "chart c: good has y = nan at x = 2; a curve needs finite numbers, or a gap()",
                         std::invalid_argument);
    CHECK_THROWS_WITH(chart.add("good", 2, infinity), doctest::Contains("good has y = inf at x = 2"));
    CHECK_THROWS_WITH(chart.add("good", infinity, 2), doctest::Contains("good has x = inf"));
    CHECK_THROWS_WITH(chart.row({"good", "", 2}), doctest::Contains("good has x ="));
    CHECK(to_csv(chart.data().table) == "series,x,y\ngood,1,1\n");

    Chart bars{"c", "t", {.x = "time [s]", .y = "error", .columns = speed_accuracy()}};
    CHECK_NOTHROW(bars.row({"good", 1, 0.5, 0.25, 0.125}));
    CHECK_THROWS_WITH(bars.row({"good", 1, 0.5, 0.25, infinity}), doctest::Contains("error_se = inf"));
}

TEST_CASE("rows without a curve's name are kept, and not drawn") {
    Chart chart{"c", "t", {.x = "x", .y = "y"}};
    chart.add("a", 1, 1);
    chart.add("", 2, 1000);
    chart.add("a", 3, 3);
    const Curves curves = curves_of(chart.data(), grouped_by_series(chart.data()));
    REQUIRE(curves.shown.size() == 1);
    CHECK(curves.shown[0].points == std::vector<Point>{{1, 1}, {3, 3}});
    CHECK(curves.shown[0].last_row == 1);
    CHECK(curves.not_shown.empty());
    CHECK(to_csv(grouped_by_series(chart.data())) == "series,x,y\na,1,1\na,3,3\n,2,1000\n");
}

TEST_CASE("a gap interrupts the line") {
    const auto with = [](bool gap) {
        Chart chart{"c", "t", {.x = "x", .y = "y"}};
        for (const double x : {1.0, 2.0, 3.0}) {
            if (gap && x == 2)
                chart.gap("a", x);
            else
                chart.add("a", x, x);
        }
        chart.gap("b", 1);
        return chart;
    };
    const Chart  chart  = with(true);
    const Curves curves = curves_of(chart.data(), grouped_by_series(chart.data()));
    REQUIRE(curves.shown.size() == 1);
    CHECK(curves.shown[0].points == std::vector<Point>{{1, 1}, {3, 3}});
    CHECK(curves.not_shown == "not shown: b (nothing but gaps)");
    CHECK(to_csv(chart.data().table) == "series,x,y\na,1,1\na,2,nan\na,3,3\nb,1,nan\n");

    const test::ScratchFolder folder{"gap"};
    const auto                lines_drawn = [&](const Chart& drawn) {
        write_csv(folder.path / "c.csv", grouped_by_series(drawn.data()));
        const auto picture = run_gnuplot(chart_script(drawn.data(), folder.path / "c.csv", "svg"));
        return picture ? std::count(picture->begin(), picture->end(), 'L')
                                      : -1;  // "M1,1 L2,2" is a line in SVG
    };
    const auto whole = lines_drawn(with(false));
    if (whole >= 0) CHECK(lines_drawn(chart) == whole - 2);
}

TEST_CASE("a closed form is a line without points, and what is measured are points with bars") {
    Chart chart{"c", "t", {.x = "time [s]", .y = "error", .columns = speed_accuracy()}};
    for (const double x : {1.0, 2.0, 3.0}) {
        chart.add("law", x, x, {0, 0});
        chart.add("measured", x, x, {0, 0.25});
        chart.add("neither", x, 2 * x, {0, 0.25});
    }
    const std::string both = chart_script(chart.data(), "c.csv", "svg");
    CHECK(both.find("title 'law' with linespoints") != std::string::npos);

    chart.as_line("law");
    chart.as_points("measured");
    const std::string script = chart_script(chart.data(), "c.csv", "svg");
    CHECK(script.find("title 'law' with lines ") != std::string::npos);
    CHECK(script.find("title 'law' with linespoints") == std::string::npos);
    CHECK(script.find("title 'measured' with vectors") != std::string::npos);  // its bars
    CHECK(script.find("title 'measured' with points") != std::string::npos);
    CHECK(script.find("title 'neither' with linespoints") != std::string::npos);

    chart.as_line("lwa");
    CHECK_THROWS_WITH_AS((void)laid_out(chart), "chart c: no curve lwa to draw as a line or as points",
                         std::invalid_argument);
}

TEST_CASE("a curve has the colour that it is given, on any chart, and a dashed one belongs to another") {
    Chart chart{"c", "t", {.x = "x", .y = "y"}};
    for (const char* curve : {"first", "second", "third"})
        for (const double x : {1.0, 2.0}) chart.add(curve, x, x);
    chart.in_ink("third", Ink::blue);
    chart.as_dashed("third");
    const auto curves = curves_of(chart.data(), grouped_by_series(chart.data())).shown;
    REQUIRE(curves.size() == 3);
    CHECK(curves[0].ink == Ink::blue);  // the first Ink
    CHECK(curves[1].ink == Ink::vermilion);
    CHECK(curves[2].ink == Ink::blue);  // and not green, which is the third
    const std::string script = chart_script(chart.data(), "c.csv", "svg");
    const auto        dashes = script.find("dashtype 2");
    REQUIRE(dashes != std::string::npos);
    CHECK(script.find("title 'third' with linespoints") < dashes);
    CHECK(script.rfind("dashtype 2") == dashes);  // of the third alone

    chart.in_ink("thrid", Ink::blue);
    CHECK_THROWS_WITH_AS((void)laid_out(chart), "chart c: no curve thrid to draw in a colour of its own",
                         std::invalid_argument);
}

TEST_CASE("a band is shaded from one x to the other, and named inside") {
    Chart chart{"c", "t", {.x = "x", .y = "y"}};
    chart.add("a", 0, 0);
    chart.add("a", 10, 1);
    chart.mark_band(4, 8, "band");
    const Frame frame = laid_out(chart);
    REQUIRE(frame.labels.size() == 2);
    CHECK(frame.labels.back().at.x > frame.x(4));
    CHECK(frame.labels.back().at.x + text_width("band", FontSize::normal) < frame.x(8));
    CHECK(chart_script(chart.data(), "c.csv", "svg").find("from first 4, graph 0 to first 8, graph 1") !=
          std::string::npos);
}

TEST_CASE("the name of a vertical line stands on none of them, also not on one that is marked later") {
    Chart chart{"c", "t", {.x = "x", .y = "y"}};
    chart.add("a", 0, 0);
    chart.add("a", 10, 0);
    for (const double x : {5.0, 5.25}) chart.mark_x(x, "bound");
    const Frame frame = laid_out(chart);
    int         names = 0;
    for (const PlacedLabel& label : frame.labels) {
        if (label.lines != std::vector<std::string>{"bound"}) continue;
        ++names;
        for (const double x : {5.0, 5.25})
            CHECK(
                (frame.x(x) < label.at.x || frame.x(x) > label.at.x + text_width("bound", FontSize::normal)));
    }
    CHECK(names == 2);
}

TEST_CASE("a logarithmic axis shows 0 below its numbers, and names under the chart what it can't show") {
    Chart chart{"c", "t", {.x = "x", .y = "y", .log = axis::y}};
    for (const double x : {1.0, 2.0}) {
        chart.add("float, camera space", x, 0);
        chart.add("below", x, -x);
        chart.add("good", x, x == 1 ? 0 : 3);
    }
    const Curves curves = curves_of(chart.data(), grouped_by_series(chart.data()));
    REQUIRE(curves.shown.size() == 2);
    CHECK(curves.shown[0].points == std::vector<Point>{{1, 0}, {2, 0}});
    CHECK(curves.shown[1].name == "good");
    CHECK(curves.shown[1].ink == Ink::green);  // the third, as in a chart that shows all three
    CHECK(curves.shown[1].points == std::vector<Point>{{1, 0}, {2, 3}});
    CHECK(curves.not_shown == "not shown: below (nowhere above 0)");
    const Scale y = laid_out(chart).y;
    CHECK(y.shows_zero());
    CHECK(y(0) > y.from);
    CHECK(y(0) < y(y.lowest));
    CHECK(y.lowest < 3);
    CHECK(laid_out(chart).caption == std::vector{curves.not_shown});
    CHECK(grouped_by_series(chart.data()).rows.size() == 6);
    const std::string script = chart_script(chart.data(), "c.csv", "svg");
    CHECK(script.find("every ::4::5") != std::string::npos);
    CHECK(script.find("every ::2::3") == std::string::npos);
    CHECK(script.find("'0' ") != std::string::npos);

    Chart none{"c", "t", {.x = "x", .y = "y", .log = axis::y}};
    none.add("zero", 1, 0);
    CHECK_THROWS_WITH_AS((void)laid_out(none),
                         "chart c: nothing can be drawn on its axes; not shown: zero (0 everywhere); a "
                         "logarithmic axis needs a value above 0",
                         std::invalid_argument);
}

TEST_CASE("a logarithmic axis of three decades or more is numbered in powers of ten") {
    const auto script = [](double last) {
        Chart chart{"c", "t", {.x = "x", .y = "y", .log = axis::x}};
        chart.add("a", 0.01, 1);
        chart.add("a", last, 2);
        return chart_script(chart.data(), "c.csv", "svg");
    };
    CHECK(script(100).find("10^{2}") != std::string::npos);
    CHECK(script(100).find("'100'") == std::string::npos);
    CHECK(script(1).find("'0.01'") != std::string::npos);
    CHECK(script(1).find("10^") == std::string::npos);
    const auto pixels = [] {
        Chart chart{"c", "t", {.x = "x", .y = "y", .log = axis::x}};
        chart.add("a", 256, 1);
        chart.add("a", 65536, 2);
        return chart_script(chart.data(), "c.csv", "svg");
    };
    CHECK(pixels().find("'10\u00a0000'") != std::string::npos);
}

TEST_CASE("of many powers of ten about eight are named, also where the axis shows 0") {
    for (const double least : {0.0, 1e-14}) {
        Chart chart{"c", "t", {.x = "x", .y = "y", .log = axis::y}};
        chart.add("a", 1, 1e-14);
        chart.add("a", 2, 1);
        chart.add("b", 1, least);
        const std::string script = chart_script(chart.data(), "c.csv", "svg");
        CHECK(script.find("'10^{−14}' 1e-14") != std::string::npos);
        CHECK(script.find("'' 1e-13 1") != std::string::npos);
        CHECK(script.find("'10^{0}' 1") != std::string::npos);
        CHECK(script.find("10^{−13}") == std::string::npos);
    }
}

TEST_CASE("gnuplot draws every format from the CSV") {
    if (!run_gnuplot("set terminal dumb\nplot x")) {
        MESSAGE("gnuplot is not installed: nothing was drawn");
        return;
    }
    const test::ScratchFolder folder{"it's a chart"};
    Chart                     chart = crowded();
    chart.caption("a \"quoted\" word & more, and it's one");
    write_csv(folder.path / "c.csv", grouped_by_series(chart.data()));
    const std::pair<const char*, const char*> starts[] = {
        {"svg", "<?xml"}, {"png", "\x89PNG"}, {"pdf", "%PDF"}, {"tex", "\\begin{tikz"}};
    for (const auto& [format, start] : starts) {
        const auto picture = run_gnuplot(chart_script(chart.data(), folder.path / "c.csv", format));
        REQUIRE(picture);
        CHECK(picture->find(start) != std::string::npos);
        if (std::string{format} == "svg")
            for (const char* text : {"method_0", "method_4", "crossover", "error [1]", "&amp; more"})
                CHECK(picture->find(text) != std::string::npos);
        CHECK(picture->find("c.csv") == std::string::npos);
    }
    CHECK(Dialect{"tex"}.finished("\\begin").starts_with("% needs \\usepackage{gnuplot-lua-tikz}\n\\begin"));
    // without the file there is no picture: it is the CSV that is drawn
    CHECK_THROWS_WITH_AS((void)run_gnuplot(chart_script(chart.data(), folder.path / "none.csv", "svg")),
                         doctest::Contains("none.csv"), std::runtime_error);
}

TEST_CASE("gnuplot's own words are passed on, and its absence is no error") {
    const Ended without = test::in_child([] {
        ::setenv("PATH", "/no/such/folder", 1);
        return run_gnuplot("plot x") ? 1 : 0;
    });
    CHECK(without.code == 0);
    if (run_gnuplot("set terminal dumb\nplot x"))
        CHECK_THROWS_WITH_AS((void)run_gnuplot("plot foo\n"), doctest::Contains("undefined variable: foo"),
                             std::runtime_error);
}

TEST_CASE("a diagram's rows are its shapes, and gnuplot draws them") {
    Diagram diagram{"d", "t"};
    diagram.line({0, 0}, {1, 0});
    diagram.arrow({0, 0}, {2, 1}, {.ink = Ink::blue});
    diagram.polygon({{0, 0}, {1, 0}, {0, 1}}, {}, 0.25);
    diagram.label({1, 1}, "$t_{\\min}$, 50% & more");
    diagram.point({3, 3});
    CHECK(
        to_csv(to_rows(diagram.data())) ==
        "shape,kind,x,y,dx,dy,text\n1,line,0,0,0,0,\n1,line,1,0,0,0,\n2,arrow,0,0,2,1,\n3,area,0.5,0,0,0,\n"
        "3,area,1,0,0,0,\n3,area,0,1,0,0,\n3,area,0,0,0,0,\n3,area,0.5,0,0,0,\n4,label,1,1,0,0,\"$t_{\\min}$,"
        " 50% & more\"\n"
        "5,point,3,3,0,0,\n");
    const test::ScratchFolder folder{"diagram"};
    write_csv(folder.path / "d.csv", to_rows(diagram.data()));
    for (const char* format : {"svg", "png", "pdf", "tex"})
        if (const auto picture = run_gnuplot(diagram_script(diagram.data(), folder.path / "d.csv", format)))
            CHECK(picture->find("d.csv") == std::string::npos);  // no path of the machine that drew it
    CHECK_THROWS_AS((void)diagram_script(Diagram{"e", "t"}.data(), "e.csv", "svg"), std::invalid_argument);
}
