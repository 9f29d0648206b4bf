#pragma once
/// @file implicit_tanglecube.hpp

#include <cmath>
#include <concepts>

#include "geometry/box.hpp"
#include "math/square.hpp"
#include "math/vector.hpp"

namespace sr {

/// x^4 - 5 x^2 + y^4 - 5 y^2 + z^4 - 5 z^2 + level = 0: eight rounded corners and the twelve edges between them.
/// Written with completed squares, so that each coordinate occurs once and an interval's bounds are tight.
/// @pre 6.25 < level < 12.5: below, the corners fall apart or fill up; above they are gone
template <std::floating_point T>
struct Tanglecube {
    T level = T(11.8);

    template <class Number>
    [[nodiscard]] auto f(const Number& x, const Number& y, const Number& z) const {
        const auto axis = [](const Number& u) { return square(square(u) - T(2.5)); };  // u^4 - 5 u^2 + 6.25
        return axis(x) + axis(y) + axis(z) + (level - T(18.75));
    }

    /// On one axis u^4 - 5 u^2 <= 12.5 - level, because the other two are -6.25 at least.
    [[nodiscard]] Box<T> bounds() const {
        const Vector3<T> corner(std::sqrt(T(2.5) + std::sqrt(T(18.75) - level)));
        return {-corner, corner};
    }
};

}  // namespace sr
