#pragma once
/// @file system_check.hpp
/// Which systems have a solution that is light.

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

/// @param tolerance by how much rows of form factors may sum to more than 1
/// @throws std::invalid_argument with patch, value and what would be right: sizes that differ; a reflectance that is
///         not from 0 to 1; a negative or infinite form factor, emission or area; a row that sums to more than 1; the
///         patches of a perfect enclosure
void check_system(const RadiositySystem& system, double tolerance = 1e-6);

}  // namespace sr
