/// @file law.cpp
/// The arguments on which laws are tried are as various as they should be, and a wrong law is found out.

#include "law.hpp"

#include <cmath>
#include <set>

using namespace sr::test;

namespace {

/// How many of a hundred thousand arguments have the property.
template <class T, class Property>
int count(const rc::Gen<T>& arguments, Property&& has) {
    int        result = 0;
    rc::Random random(1);
    for (int i = 0; i < 100'000; ++i) result += has(arguments(random.split(), 100).value()) ? 1 : 0;
    return result;
}

}  // namespace

TEST_CASE_TEMPLATE("any bits means all of them", T, float, double) {
    const auto any = any_bits<T>();
    CHECK(count(any, [](T x) { return std::isnan(x); }) >= 1000);
    CHECK(count(any, [](T x) { return std::isinf(x); }) >= 1000);
    CHECK(count(any, [](T x) { return std::fpclassify(x) == FP_SUBNORMAL; }) >= 1000);
    CHECK(count(any, [](T x) { return x == 0 && std::signbit(x); }) >= 1000);
    CHECK(count(any, [](T x) { return std::isfinite(x) && std::signbit(x); }) >= 10'000);
    std::set<int> exponents;
    (void)count(any, [&](T x) { return exponents.insert(std::isnormal(x) ? std::ilogb(x) : 0).second; });
    CHECK(exponents.size() >= 250);
}

TEST_CASE_TEMPLATE("the numbers of a scene are finite, large and small", T, float, double) {
    const auto some = finite<T>();
    CHECK(count(some, [](T x) { return std::abs(x) < T(0x1p20); }) == 100'000);
    CHECK(count(some, [](T x) { return x == 0; }) >= 1000);
    CHECK(count(some, [](T x) { return std::abs(x) > 1000; }) >= 10'000);
    CHECK(count(some, [](T x) { return std::abs(x) > 0 && std::abs(x) < T(0.001); }) >= 10'000);
    CHECK(count(some, [](T x) { return x < 0; }) >= 40'000);
    CHECK(count(nonzero<T>(), [](T x) { return x != 0; }) == 100'000);
}

TEST_CASE("a law that holds nearly always is found to be none, and by which argument") {
    const auto told = counterexample([] {
        const float x = *finite<float>();
        RC_ASSERT(x + 2e-4F != x);
    });
    CHECK(told.find("4096") != std::string::npos);  // the smallest float whose neighbours are so far away
}
