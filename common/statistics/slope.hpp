#pragma once
/// @file slope.hpp

#include <span>

#include "statistics/estimate.hpp"

namespace sr {

/// The exponent p of a power law y = a x^p, as a chart with two logarithmic axes shows it.
struct Slope {
    double value;
    double standard_error;  ///< from the scatter of the points about the line
};

/// Least squares of log y on log x: slope = S_xy / S_xx, its squared error = (S_yy - slope S_xy) / (n - 2) / S_xx.
/// @pre    as many x as y, three points or more, all positive and finite, not all at one x
/// @throws std::invalid_argument otherwise
[[nodiscard]] Slope log_log_slope(std::span<const double> x, std::span<const double> y);

/// The same slope with the error that follows from those of the y: few points may well lie on a line by chance. It is
/// sum_i (dx_i / S_xx) log y_i, dx the differences from the mean of log x, and d(log y) = dy / y.
/// @pre    also: no error is negative, and all are finite
/// @throws std::invalid_argument otherwise
[[nodiscard]] Slope log_log_slope(std::span<const double> x, std::span<const Estimate> y);

}  // namespace sr
