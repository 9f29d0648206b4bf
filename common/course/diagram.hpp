#pragma once
/// @file diagram.hpp
/// A drawing for a lecture: lines, arrows, areas and labels on a plane with equal units and no axes.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "course/csv.hpp"
#include "course/label_layout.hpp"
#include "course/style.hpp"

namespace sr::course {

enum class Weight { thin, medium, thick };

/// How a line is drawn.
struct Pen {
    Ink    ink    = Ink::black;
    Weight weight = Weight::medium;
    bool   dashed = false;
};

/// Which part of a label stands at its point.
enum class Anchor { left, centre, right };

/// One thing on the plane: its kind, its points and how it is drawn.
struct Shape {
    enum class Kind { line, arrow, area, point, label };

    Kind               kind;
    std::vector<Point> points;
    Pen                pen     = {};
    double             opacity = 0;   ///< of an area's inside, 0 to 1
    std::string        text    = {};  ///< of a label, in TeX
    Anchor             anchor  = Anchor::left;
};

/// Everything that a diagram holds.
struct DiagramData {
    std::string        name;   ///< stem of its files
    std::string        title;  ///< TeX
    std::vector<Shape> shapes  = {};
    std::string        caption = {};  ///< TeX
};

/// Handle of a diagram; copies draw on the same plane. What is drawn later lies on top; labels on top of all.
class Diagram {
public:
    Diagram(std::string name, std::string title);

    void line(Point from, Point to, Pen pen = {});
    void line(std::vector<Point> through, Pen pen = {});
    void arrow(Point from, Point to, Pen pen = {});  ///< head at `to`
    void polygon(std::vector<Point> corners, Pen pen = {}, double opacity = 0);
    void point(Point at, Pen pen = {});  ///< smaller if thin
    void label(Point at, std::string tex, Anchor anchor = Anchor::left, Ink ink = Ink::black);

    void caption(std::string text) { data_->caption = std::move(text); }

    [[nodiscard]] const DiagramData& data() const { return *data_; }

    /// Whether no other handle is left that could draw on it.
    [[nodiscard]] bool is_complete() const { return data_.use_count() == 1; }

private:
    std::shared_ptr<DiagramData> data_;
};

/// The shapes as the CSV holds them, a row for each point: shape,kind,x,y,dx,dy,text. An arrow is one row.
[[nodiscard]] Rows to_rows(const DiagramData& diagram);

}  // namespace sr::course
