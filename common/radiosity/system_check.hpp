#pragma once
/// @file system_check.hpp
/// Which systems have a solution that is light: none of it negative, and what Jacobi's method with lambda = 1 comes to.

#include <cstddef>
#include <vector>

#include "radiosity/radiosity_system.hpp"

namespace sr {

/// Sets of patches that keep all light in some primary: they reflect all of it, and only to each other. Light that gets
/// there grows without end, so that there is no solution; and if none does, then any amount of it is one. Each set is
/// sorted, and the sets are in the order of their first patches.
/// @param tolerance for the sums of rows: 1 - tolerance is taken for 1
[[nodiscard]] std::vector<std::vector<std::size_t>> perfect_enclosures(const RadiositySystem& system,
                                                                       double tolerance = 1e-6);

/// What passes has a solution that is light: from each patch some gets to where some is lost, and where rows sum to
/// more than 1, light still gets less with its bounces. Not detected are form factors that are wrong and sum to 1 or
/// less.
/// @param tolerance by how much rows of form factors may sum to more than 1
/// @throws std::invalid_argument with patch, value and what would be right: sizes that differ; a reflectance that is
///         not from 0 to 1; a negative or infinite form factor, emission or area; a row that sums to more than 1;
///         the patches of a perfect enclosure; light that gets no less because of rows above 1
void check_system(const RadiositySystem& system, double tolerance = 1e-6);

}  // namespace sr
