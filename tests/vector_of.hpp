#pragma once
/// @file vector_of.hpp

#include <rapidcheck.h>

#include <concepts>

#include "math/vector.hpp"

namespace sr::test {

/// A vector of three such numbers, drawn inside a law: `vector_of(any_bits<T>())`.
template <std::floating_point T>
[[nodiscard]] Vector3<T> vector_of(const rc::Gen<T>& number) {
    const T x = *number, y = *number, z = *number;
    return {x, y, z};
}

}  // namespace sr::test
