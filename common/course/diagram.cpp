/// @file diagram.cpp

#include "course/diagram.hpp"

#include <algorithm>
#include <stdexcept>

namespace sr::course {

namespace {

using Kind = Shape::Kind;

const char* name_of(Kind kind) {
    constexpr const char* names[] = {"line", "arrow", "area", "point", "label"};
    return names[int(kind)];
}

}  // namespace

Diagram::Diagram(std::string name, std::string title)
    : data_{std::make_shared<DiagramData>(DiagramData{.name = std::move(name), .title = std::move(title)})} {}

void Diagram::line(Point from, Point to, Pen pen) {
    line(std::vector{from, to}, pen);
}

void Diagram::line(std::vector<Point> through, Pen pen) {
    data_->shapes.push_back({.kind = Kind::line, .points = std::move(through), .pen = pen});
}

void Diagram::arrow(Point from, Point to, Pen pen) {
    data_->shapes.push_back({.kind = Kind::arrow, .points = {from, to}, .pen = pen});
}

void Diagram::polygon(std::vector<Point> corners, Pen pen, double opacity) {
    if (corners.size() < 3)
        throw std::invalid_argument("diagram " + data_->name + ": a polygon needs three corners");
    // the outline begins in the middle of a side: at a corner its two ends would leave a notch
    const Point middle = 0.5 * (corners[0] + corners[1]);
    std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    corners.insert(corners.begin(), middle);
    corners.push_back(middle);
    data_->shapes.push_back(
        {.kind = Kind::area, .points = std::move(corners), .pen = pen, .opacity = opacity});
}

void Diagram::point(Point at, Pen pen) {
    data_->shapes.push_back({.kind = Kind::point, .points = {at}, .pen = pen});
}

void Diagram::label(Point at, std::string tex, Anchor anchor, Ink ink) {
    data_->shapes.push_back(
        {.kind = Kind::label, .points = {at}, .pen = {.ink = ink}, .text = std::move(tex), .anchor = anchor});
}

Rows to_rows(const DiagramData& diagram) {
    Rows rows{{"shape", "kind", "x", "y", "dx", "dy", "text"}};
    int  number = 0;
    for (const Shape& shape : diagram.shapes) {
        const Point first = shape.points.front();
        const auto  row   = [&](Point p, Point d) {
            rows.add({number, name_of(shape.kind), p.x, p.y, d.x, d.y, shape.text});
        };
        ++number;
        if (shape.kind == Kind::arrow)
            row(first, shape.points.back() - first);
        else
            for (const Point& p : shape.points) row(p, {0, 0});
    }
    return rows;
}

}  // namespace sr::course
