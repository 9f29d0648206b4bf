/// @file form_factor_matrix.cpp

#include "radiosity/form_factor_matrix.hpp"

#include <fmt/format.h>

#include <new>
#include <stdexcept>

namespace sr {
namespace {

std::vector<double> zeros(std::size_t n) {
    try {
        if (n > 0 && n > std::vector<double>{}.max_size() / n) throw std::bad_alloc();
        return std::vector<double>(n * n);
    } catch (const std::bad_alloc&) {
        throw std::length_error(fmt::format(
            "the form factors between {} patches take {:.3g} GiB, and there is not so much memory; "
            "take fewer patches, or hierarchical_radiosity()",
            n, 8.0 * double(n) * double(n) / (1 << 30)));
    }
}

}  // namespace

FormFactorMatrix::FormFactorMatrix(std::size_t n) : n_{n}, values_{zeros(n)} {}

}  // namespace sr
