#pragma once
/// @file running.hpp

#include <cmath>
#include <cstdint>
#include <limits>

namespace sr {

/// Mean and variance of numbers that come one at a time, and of the parts of a sum that threads share.
///
/// Each value moves the mean, and squares are taken of differences from it. The textbook E[x^2] - E[x]^2
/// squares first, and loses the variance of values that lie far from 0.
/// @see Welford, Technometrics 4 (1962); Chan, Golub and LeVeque, The American Statistician 37 (1983)
class Running {
public:
    constexpr void add(double x) {
        ++count_;
        const double difference = x - mean_;
        mean_ += difference / double(count_);
        squares_ += difference * (x - mean_);
    }

    /// As if the other's values had been added here, up to rounding.
    constexpr void merge(const Running& other) {
        if (other.count_ == 0) return;
        const auto   n          = double(count_ + other.count_);
        const double share      = double(other.count_) / n;
        const double difference = other.mean_ - mean_;
        squares_ += other.squares_ + difference * difference * share * double(count_);
        mean_ += difference * share;
        count_ += other.count_;
    }

    [[nodiscard]] constexpr std::uint64_t count() const { return count_; }

    /// 0 before the first value.
    [[nodiscard]] constexpr double mean() const { return mean_; }

    /// Unbiased estimate of the variance of one value; NaN, unknown, of fewer than two.
    [[nodiscard]] constexpr double variance() const {
        return count_ < 2 ? std::numeric_limits<double>::quiet_NaN() : squares_ / double(count_ - 1);
    }

    /// Standard error of the mean: sqrt(variance / n); NaN, unknown, of fewer than two values.
    [[nodiscard]] double standard_error() const { return std::sqrt(variance() / double(count_)); }

private:
    std::uint64_t count_   = 0;
    double        mean_    = 0;
    double        squares_ = 0;  // sum of (x - mean)^2
};

}  // namespace sr
