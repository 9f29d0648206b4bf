/// @file slope.cpp

#include "statistics/slope.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "statistics/running.hpp"

namespace sr {
namespace {

double checked_log(double value, std::size_t point) {
    if (value > 0 && value <= std::numeric_limits<double>::max()) return std::log(value);
    throw std::invalid_argument("log-log slope: point " + std::to_string(point) + " is at " +
                                std::to_string(value) + "; must be positive and finite");
}

}  // namespace

Slope log_log_slope(std::span<const double> x, std::span<const double> y) {
    if (x.size() != y.size() || x.size() < 3) {
        throw std::invalid_argument("log-log slope of " + std::to_string(x.size()) + " x and " +
                                    std::to_string(y.size()) + " y; must be three or more of each");
    }
    Running log_x, log_y;
    for (std::size_t i = 0; i < x.size(); ++i) {
        log_x.add(checked_log(x[i], i));
        log_y.add(checked_log(y[i], i));
    }

    // from differences to the means, which is where the digits are
    double sxx = 0, sxy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double dx = std::log(x[i]) - log_x.mean();
        sxx += dx * dx;
        sxy += dx * (std::log(y[i]) - log_y.mean());
    }
    if (!(sxx > 0))
        throw std::invalid_argument("log-log slope: all points are at one x; must be two or more");
    const double slope = sxy / sxx;

    double residuals = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double above = std::log(y[i]) - log_y.mean() - slope * (std::log(x[i]) - log_x.mean());
        residuals += above * above;
    }
    return {slope, std::sqrt(residuals / double(x.size() - 2) / sxx)};
}

Slope log_log_slope(std::span<const double> x, std::span<const Estimate> y) {
    std::vector<double> values;
    for (const Estimate& of : y) values.push_back(of.value);
    const double slope = log_log_slope(x, values).value;

    Running log_x;
    for (const double at : x) log_x.add(std::log(at));
    double sxx = 0, squares = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double dx = std::log(x[i]) - log_x.mean(), dy = y[i].error / y[i].value;
        if (!(dy >= 0 && dy <= std::numeric_limits<double>::max()))
            throw std::invalid_argument("log-log slope: point " + std::to_string(i) + " has the error " +
                                        std::to_string(y[i].error) + "; must be 0 or more and finite");
        sxx += dx * dx;
        squares += dx * dx * dy * dy;
    }
    return {slope, std::sqrt(squares) / sxx};
}

}  // namespace sr
