#pragma once
/// @file visible.hpp

#include <concepts>
#include <cstdint>
#include <limits>

#include "image/image.hpp"

namespace sr {

/// What a pixel sees first: a face of the mesh at r(t), or nothing.
template <std::floating_point T>
struct Visible {
    static constexpr std::uint32_t nothing = std::numeric_limits<std::uint32_t>::max();

    T             t    = std::numeric_limits<T>::infinity();
    std::uint32_t face = nothing;

    [[nodiscard]] bool hit() const { return face != nothing; }
    friend bool        operator==(const Visible&, const Visible&) = default;
};

/// The answer to "what is seen through each pixel?", before anything is shaded. Rasteriser and ray tracer
/// both give it.
template <std::floating_point T>
using VisibilityImage = Image<Visible<T>>;

}  // namespace sr
