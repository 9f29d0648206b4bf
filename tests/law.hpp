#pragma once
/// @file law.hpp
/// A law is what holds for all arguments. How to use:
///     TEST_CASE("roots") {
///         check_law("the roots are in order", [] {
///             const double a = *finite<double>(), b = *finite<double>(), c = *finite<double>();
///             const auto roots = quadratic_roots(a, b, c);
///             RC_PRE(roots.has_value());
///             RC_ASSERT(roots->first <= roots->second);
///         });
///     }
/// RC_ASSERT takes a condition apart, and evaluates both sides of && and ||: such a one needs its own parentheses.

#include <doctest/doctest.h>
#include <rapidcheck.h>
#include <rapidcheck/detail/TestListenerAdapter.h>

#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <sstream>
#include <string>
#include <type_traits>
#include <unordered_map>

namespace sr::test {

/// Tries the law on random arguments, the same ones on every run.
/// @return the smallest counterexample that was found, and what it breaks; empty if the law held
template <class Law>
[[nodiscard]] std::string counterexample(const Law& law, int cases = 2000) {
    rc::detail::TestParams params;
    params.seed       = 1;
    params.maxSuccess = cases;
    rc::detail::TestListenerAdapter silent;  // doctest speaks, and the usual one speaks of a random seed
    const auto result = rc::detail::checkTestable(law, rc::detail::TestMetadata{}, params, silent,
                                                  std::unordered_map<std::string, rc::detail::Reproduce>{});
    if (result.template is<rc::detail::SuccessResult>()) return "";
    std::ostringstream told;
    rc::detail::printResultMessage(result, told);
    return told.str();
}

template <class Law>
void check_law(const std::string& what, const Law& law, int cases = 2000) {
    INFO(what);
    CHECK(counterexample(law, cases) == "");
}

template <std::floating_point T>
using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;

/// Every bit pattern of the type: all magnitudes, zeros of both signs, denormals, infinities and NaN.
template <std::floating_point T>
[[nodiscard]] rc::Gen<T> any_bits() {
    using Limits = std::numeric_limits<T>;
    const auto patterns =
        rc::gen::map(rc::gen::resize(100, rc::gen::arbitrary<Bits<T>>()),  // 100: of all sizes, the full one
                     [](Bits<T> bits) { return std::bit_cast<T>(bits); });
    return rc::gen::weightedOneOf<T>(
        {{3, patterns},
         {1,
          rc::gen::element(T(0), -T(0), T(1), T(-1), Limits::min(), Limits::denorm_min(), Limits::max(),
                           Limits::lowest(), Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN())}});
}

/// Numbers of a scene: 0, and of both signs from 2^-20 to 2^20, each power of two as likely.
template <std::floating_point T>
[[nodiscard]] rc::Gen<T> finite() {
    const auto spread = rc::gen::apply(
        [](int exponent, std::uint32_t digits, bool negative) {
            const T value = std::ldexp(T(1) + T(digits) * T(0x1p-24), exponent);
            return negative ? -value : value;
        },
        rc::gen::inRange(-20, 20), rc::gen::inRange(0U, 1U << 24), rc::gen::arbitrary<bool>());
    return rc::gen::weightedOneOf<T>({{9, spread}, {1, rc::gen::element(T(0), T(1), T(-1))}});
}

/// As `finite`, and not 0.
template <std::floating_point T>
[[nodiscard]] rc::Gen<T> nonzero() {
    return rc::gen::suchThat(finite<T>(), [](T value) { return value != 0; });
}

}  // namespace sr::test
