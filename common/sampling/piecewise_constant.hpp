#pragma once
/// @file piecewise_constant.hpp
/// Numbers in [0, 1), and points of the unit square, whose density is a table: a histogram, a sky's picture, a row of
/// lamps' powers.
///
///     const PiecewiseConstant<float> table(std::vector{1.0F, 0.0F, 3.0F});
///     const float x = table.sample(u);  // below 1/3 or from 2/3 on, never between
///
/// No bin is drawn whose value is 0, whatever u is; so dividing by the density is safe. In float, u has 2^24 values: of
/// bins that are drawn more rarely than that, some never are.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>
#include <ranges>
#include <span>
#include <stdexcept>
#include <vector>

#include "math/vector.hpp"

namespace sr {

/// n bins of the same width.
template <std::floating_point T>
class PiecewiseConstant {
public:
    /// @param  values  one a bin; only their ratios matter
    /// @throws std::invalid_argument of a value that is negative or not finite, if their sum is 0 or not finite, and of
    ///         more bins than T tells apart
    template <std::ranges::input_range Values>
    explicit PiecewiseConstant(const Values& values) : below_{0} {
        for (const auto value : values) {
            if (!(value >= 0 && std::isfinite(value)))
                throw std::invalid_argument(fmt::format(
                    "table: value {} is {}; must be finite and not negative", below_.size() - 1, value));
            below_.push_back(below_.back() + double(value));
        }
        constexpr std::size_t most = std::size_t{1} << (std::numeric_limits<T>::digits - 2);
        if (size() > most)
            throw std::invalid_argument(fmt::format("table: {} values; must be {} at most", size(), most));
        sum_ = below_.back();
        if (!(sum_ > 0 && std::isfinite(sum_)))
            throw std::invalid_argument(
                fmt::format("table: its values add up to {}; must be positive and finite", sum_));
        for (double& share : below_) share /= sum_;  // the last one to exactly 1
    }

    /// How many bins.
    [[nodiscard]] std::size_t size() const { return below_.size() - 1; }

    /// Of all values.
    [[nodiscard]] double sum() const { return sum_; }

    /// With which a bin is drawn.
    [[nodiscard]] double probability(std::size_t bin) const { return below_[bin + 1] - below_[bin]; }

    /// The bin in which a number lies. The bin k begins at k / n, rounded: the product x n may be rounded across.
    /// @pre 0 <= x < 1
    [[nodiscard]] std::size_t bin_of(T x) const {
        const std::size_t near = std::min(std::size_t(x * T(size())), size() - 1);
        if (x < start(near)) return near - 1;
        return x < start(near + 1) ? near : near + 1;
    }

    /// A bin, drawn with its probability.
    struct Bin {
        std::size_t index;
        double      probability;
        double share;  ///< what is left of the number that chose it, uniform in [0, 1] again: 1 by rounding
    };

    /// Of bins that begin with the same share, all but the last are empty: it is the last share not above u that
    /// counts, and `upper_bound` finds the next one.
    /// @pre 0 <= u < 1
    [[nodiscard]] Bin choose(T u) const {
        const auto   next = std::upper_bound(below_.begin(), below_.end(), double(u));
        const auto   bin  = std::size_t(next - below_.begin()) - 1;
        const double p    = probability(bin);
        return {bin, p, (double(u) - below_[bin]) / p};
    }

    /// The cumulative density, by its inverse.
    /// @pre 0 <= u < 1
    [[nodiscard]] T sample(T u) const {
        const Bin bin = choose(u);
        const T   x   = T((double(bin.index) + bin.share) / double(size()));
        return std::clamp(x, start(bin.index), std::nextafter(start(bin.index + 1), T{0}));
    }

    /// The density [1], and 0 outside.
    [[nodiscard]] double pdf(T x) const {
        return x >= 0 && x < 1 ? probability(bin_of(x)) * double(size()) : 0;
    }

    /// The cumulative density, to rounding.
    /// @pre 0 <= x < 1
    [[nodiscard]] T invert(T x) const {
        const std::size_t bin   = bin_of(x);
        const double      share = double(x) * double(size()) - double(bin);
        return T(below_[bin] + share * probability(bin));
    }

private:
    [[nodiscard]] T start(std::size_t bin) const { return T(bin) / T(size()); }

    std::vector<double> below_;  // the share of what lies below each bin, and 1
    double              sum_ = 0;
};

/// Rows of bins, the first one at y = 0: y is drawn from the rows' sums, and x from its row.
template <std::floating_point T>
class PiecewiseConstant2D {
public:
    /// @param  values  row by row; only their ratios matter
    /// @param  width   of a row
    /// @throws std::invalid_argument if they are no rows of this width, of a value that is negative or not finite, and
    ///         if none is positive
    PiecewiseConstant2D(std::span<const T> values, std::size_t width)
        : rows_{rows(values, width)}, marginal_{sums(rows_)} {}

    /// @pre 0 <= u.x < 1 and 0 <= u.y < 1
    [[nodiscard]] Vector2<T> sample(Vector2<T> u) const {
        const T y = marginal_.sample(u.y);
        return {rows_[marginal_.bin_of(y)]->sample(u.x), y};
    }

    /// The density [1], and 0 outside.
    [[nodiscard]] double pdf(const Vector2<T>& p) const {
        const double of_row = marginal_.pdf(p.y);
        return of_row > 0 ? of_row * rows_[marginal_.bin_of(p.y)]->pdf(p.x) : 0;
    }

    /// @pre pdf(p) > 0
    [[nodiscard]] Vector2<T> invert(const Vector2<T>& p) const {
        return {rows_[marginal_.bin_of(p.y)]->invert(p.x), marginal_.invert(p.y)};
    }

private:
    using Row = std::optional<PiecewiseConstant<T>>;  // none of a row of zeros, which is never drawn

    [[nodiscard]] static std::vector<Row> rows(std::span<const T> values, std::size_t width) {
        if (width == 0 || values.size() % width != 0)
            throw std::invalid_argument(
                fmt::format("table: {} values can't be rows of {}", values.size(), width));
        std::vector<Row> made;
        for (std::size_t first = 0; first < values.size(); first += width)
            made.push_back(row(values.subspan(first, width), made.size()));
        return made;
    }

    /// A bad value is named with its row.
    [[nodiscard]] static Row row(std::span<const T> values, std::size_t index) try {
        if (std::ranges::all_of(values, [](T value) { return value == 0; })) return std::nullopt;
        return PiecewiseConstant<T>(values);
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(fmt::format("row {} of a {}", index, error.what()));
    }

    [[nodiscard]] static std::vector<double> sums(const std::vector<Row>& rows) {
        std::vector<double> sums;
        for (const Row& row : rows) sums.push_back(row ? row->sum() : 0);
        return sums;
    }

    std::vector<Row>     rows_;
    PiecewiseConstant<T> marginal_;
};

}  // namespace sr
