#pragma once
/// @file radiosity_link.hpp

#include <algorithm>
#include <array>
#include <cstdint>

namespace sr {

/// Over which one node of the quadtrees gets light from another: as one patch, from one that is its four quarters,
/// equation (8.29).
struct RadiosityLink {
    std::uint32_t receiver, source;
    float         form_factor;  ///< from the receiver to the source, with nothing between them [1]
    std::array<float, 4>
        seen;  ///< of it, the share that ends on each quarter of the source, by some rays [1]

    /// The share of the form factor that nothing is in the way of [1].
    [[nodiscard]] double visible() const {
        return std::min(1.0, double(seen[0]) + double(seen[1]) + double(seen[2]) + double(seen[3]));
    }
};

}  // namespace sr
