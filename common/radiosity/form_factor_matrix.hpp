#pragma once
/// @file form_factor_matrix.hpp

#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

namespace sr {

/// F_ij, the share of the light leaving patch i, evenly into all directions, that arrives at patch j [1]: n x n
/// numbers, row after row. They take 8 n^2 bytes: 128 MB for 4000 patches, and 29 GB for 60 000, for which
/// hierarchical_radiosity() is made.
class FormFactorMatrix {
public:
    /// Of n patches that don't see each other.
    /// @throws std::length_error if there is not so much memory, with how much it is
    explicit FormFactorMatrix(std::size_t n);

    [[nodiscard]] std::size_t size() const { return n_; }
    [[nodiscard]] double&     operator()(std::size_t i, std::size_t j) { return values_[i * n_ + j]; }
    [[nodiscard]] double      operator()(std::size_t i, std::size_t j) const { return values_[i * n_ + j]; }
    [[nodiscard]] std::span<double>       row(std::size_t i) { return {values_.data() + i * n_, n_}; }
    [[nodiscard]] std::span<const double> row(std::size_t i) const { return {values_.data() + i * n_, n_}; }

    /// The share of patch i's light that arrives anywhere: 1 in a closed scene.
    [[nodiscard]] double row_sum(std::size_t i) const {
        const auto values = row(i);
        return std::accumulate(values.begin(), values.end(), 0.0);
    }

private:
    std::size_t         n_;
    std::vector<double> values_;
};

}  // namespace sr
