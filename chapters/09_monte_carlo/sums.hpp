#pragma once
/// @file sums.hpp
/// Section 9.10: sums of very many floats.

#include <cstddef>
#include <numeric>
#include <span>

#include "math/square.hpp"
#include "sampling/rng.hpp"

namespace sr {

/// 1 + 1 + ... in float.
[[nodiscard]] inline float sum_of_ones(int n) {
    float sum = 0;
    for (int i = 0; i < n; ++i) sum += 1.0F;
    return sum;
}

/// A sum in float that carries on what each addition has lost.
/// @see Kahan, Further Remarks on Reducing Truncation Errors, Communications of the ACM 8 (1965)
class KahanSum {
public:
    void add(float x) {
        const float y    = x - lost_;
        const float next = sum_ + y;
        lost_            = (next - sum_) - y;
        sum_             = next;
    }
    [[nodiscard]] float value() const { return sum_; }

private:
    float sum_  = 0;
    float lost_ = 0;
};

/// The textbook's E[x^2] - E[x]^2, all in float.
[[nodiscard]] inline float textbook_variance(std::span<const float> values) {
    float sum = 0, squares = 0;
    for (const float x : values) {
        sum += x;
        squares += square(x);
    }
    const auto n = float(values.size());
    return squares / n - square(sum / n);
}

[[nodiscard]] inline float sum_forward(std::span<const float> values) {
    return std::accumulate(values.begin(), values.end(), 0.0F);
}

[[nodiscard]] inline float sum_backward(std::span<const float> values) {
    return std::accumulate(values.rbegin(), values.rend(), 0.0F);
}

/// In so many pieces of equal size, as threads share out a sum, and then the pieces.
/// @pre the number of values is a multiple of `pieces`
[[nodiscard]] inline float sum_in_pieces(std::span<const float> values, std::size_t pieces) {
    const std::size_t size = values.size() / pieces;
    float             sum  = 0;
    for (std::size_t i = 0; i < pieces; ++i) sum += sum_forward(values.subspan(i * size, size));
    return sum;
}

/// Halves of halves: no value goes through more additions than the logarithm of their number.
[[nodiscard]] inline float sum_pairwise(std::span<const float> values) {
    if (values.size() == 1) return values[0];
    const std::size_t half = values.size() / 2;
    return sum_pairwise(values.first(half)) + sum_pairwise(values.subspan(half));
}

}  // namespace sr
