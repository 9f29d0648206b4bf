#pragma once
/// @file radiosity_link.hpp

#include <cstdint>

namespace sr {

/// Over which one node of the quadtrees gets light from another as if each were one patch.
struct RadiosityLink {
    std::uint32_t receiver, source;
    float         form_factor;  ///< from the receiver to the source, with nothing between them [1]
    float         visible;      ///< share of it that nothing is in the way of, as some rays find it [1]
};

}  // namespace sr
