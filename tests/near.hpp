#pragma once
/// @file near.hpp

#include <doctest/doctest.h>

namespace sr::test {

/// Within this share of the expected value, however small that is: CHECK(x == near(1e-16, 1e-12)). Without a share, to
/// ten digits. doctest's own Approx takes 1 + |value| for the size of a value, and so anything below its epsilon for
/// equal to anything. NaN is near nothing, nor is anything near 0.
[[nodiscard]] inline doctest::Approx near(double expected, double share = 1e-10) {
    return doctest::Approx(expected).epsilon(share).scale(0);
}

}  // namespace sr::test
