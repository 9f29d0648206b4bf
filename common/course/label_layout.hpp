#pragma once
/// @file label_layout.hpp
/// Where labels stand so that they hide neither each other nor a curve. Units are those of the canvas, y upwards.

#include <vector>

#include "math/vector.hpp"

namespace sr::course {

using Point = Vector2<double>;

/// A rectangle: where a text stands.
struct Box {
    Point min;
    Point max;
};

/// What a label must not cover.
struct Obstacles {
    std::vector<Box>                boxes  = {};
    std::vector<std::vector<Point>> curves = {};  ///< polylines

    /// How many boxes and stretches of curves the box covers.
    [[nodiscard]] int covered_by(const Box& box) const;
};

/// The middles of labels of the heights `sizes`, one above the other in the order of `wanted`, as near to that as they
/// can be without covering each other (least squares), and between `low` and `high` where there is room. Ordered
/// regression by pooling neighbours, Barlow et al. (1972).
[[nodiscard]] std::vector<double> spread(const std::vector<double>& wanted, const std::vector<double>& sizes,
                                         double low, double high);

}  // namespace sr::course
