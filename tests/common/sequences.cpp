/// @file sequences.cpp
/// Numbers by their place, permutations, and points that share out a cube more evenly than chance does.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <set>
#include <vector>

#include "sampling/halton_point.hpp"
#include "sampling/owen.hpp"
#include "sampling/permutation.hpp"
#include "sampling/philox.hpp"
#include "sampling/random_point.hpp"
#include "sampling/sobol_point.hpp"
#include "sampling/stratified_point.hpp"
#include "statistics/tests.hpp"

using namespace sr;

namespace {

constexpr double alpha = 0.001;  // significance of each test here; seeds are fixed

/// The p-value of counts that should all be alike.
double evenness(const std::vector<std::uint64_t>& counts) {
    const auto all = std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
    return chi_square_test(counts, std::vector<double>(counts.size(), double(all) / double(counts.size()))).p;
}

/// Whether each box of 2^-a by 2^-b, a + b = k, has one of 2^k points, for all a and b.
bool is_net(const std::vector<Vector2<double>>& points) {
    const int k = int(std::lround(std::log2(points.size())));
    for (int a = 0; a <= k; ++a) {
        std::set<std::pair<int, int>> boxes;
        for (const auto& p : points) boxes.insert({int(std::ldexp(p.x, a)), int(std::ldexp(p.y, k - a))});
        if (boxes.size() != points.size()) return false;
    }
    return true;
}

/// The pair of each of n samples that follows `skipped` others.
template <SamplePoint P>
std::vector<Vector2<double>> pairs(std::uint32_t n, int skipped, std::uint64_t seed = 1) {
    std::vector<Vector2<double>> found;
    for (std::uint32_t i = 0; i < n; ++i) {
        P point({.seed = seed, .x = 3, .y = 4, .index = i, .count = n});
        for (int k = 0; k < skipped; ++k) static_cast<void>(point.template pair<double>());
        found.push_back(point.template pair<double>());
    }
    return found;
}

/// The p-value of the last sample's fourth pair, over many seeds: 8 x 8 cells.
template <SamplePoint P>
double evenness_over_seeds() {
    std::vector<std::uint64_t> counts(64);
    for (std::uint64_t seed = 0; seed < 6400; ++seed) {
        P point({.seed = seed, .x = 7, .y = 5, .index = 15, .count = 16});
        for (int k = 0; k < 3; ++k) static_cast<void>(point.template pair<float>());
        const auto p = point.template pair<float>();
        ++counts.at(std::size_t(p.x * 8) + 8 * std::size_t(p.y * 8));
    }
    return evenness(counts);
}

}  // namespace

TEST_CASE("philox: the published words of its known-answer tests") {
    constexpr auto all = ~0U;
    CHECK(philox({0, 0, 0, 0}, {0, 0}) == std::array{0x6627e8d5U, 0xe169c58dU, 0xbc57ac4cU, 0x9b00dbd8U});
    CHECK(philox({all, all, all, all}, {all, all}) ==
          std::array{0x408f276dU, 0x41c83b0eU, 0xa20bc7c6U, 0x6d5451fdU});
    CHECK(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}) ==
          std::array{0xd16cfe09U, 0x94fdccebU, 0x5001e420U, 0x24126ea1U});
}

TEST_CASE("philox: a number has its place, and pixels, samples and seeds have numbers of their own") {
    CounterRng in_order(1, 2, 3, 4);
    for (const std::uint32_t i : {0U, 1U, 2U})
        CHECK(in_order.uniform<double>() == CounterRng(1, 2, 3, 4).number<double>(i));
    std::set<double> first;
    for (const auto& rng :
         {CounterRng(1, 2, 3, 4), CounterRng(2, 2, 3, 4), CounterRng(1, 3, 3, 4), CounterRng(1, 2, 2, 4),
          CounterRng(1, 2, 3, 3), CounterRng(1ULL << 32, 2, 3, 4), CounterRng(1, 3, 2, 4)})
        first.insert(rng.number<double>(0));
    CHECK(first.size() == 7);

    std::vector<std::uint64_t> of_pixels(64), of_one(64), of_same(64);
    for (int x = 0; x < 6400; ++x) {
        ++of_pixels.at(std::size_t(64 * CounterRng(1, x, 0, 0).number<float>(0)));
        ++of_one.at(std::size_t(64 * CounterRng(1, 0, 0, 0).number<double>(std::uint32_t(x))));
        ++of_same.at(std::size_t(64 * CounterRng(1, 0, 0, 0).number<double>(std::uint32_t(x % 8))));
    }
    CHECK(evenness(of_pixels) > alpha);
    CHECK(evenness(of_one) > alpha);
    CHECK(evenness(of_same) < alpha);
}

TEST_CASE("permutation: each of n comes once, for any n, and any goes anywhere") {
    for (const std::uint32_t n : {1U, 2U, 3U, 4U, 5U, 16U, 17U, 100U, 1024U, 1025U}) {
        std::set<std::uint32_t> found;
        for (std::uint32_t i = 0; i < n; ++i) found.insert(permuted(i, n, 42));
        CHECK(found.size() == n);
        CHECK(*found.rbegin() == n - 1);
    }
    // where 0 and another one go: n (n - 1) pairs of places
    for (const std::uint32_t n : {4U, 5U, 16U, 17U, 64U})
        for (const std::uint32_t other : {1U, n / 2}) {
            const auto places_of = [&](const auto& at) {
                std::vector<std::uint64_t> counts(std::size_t{n} * (n - 1));
                for (std::uint64_t seed = 0; seed < 100 * counts.size(); ++seed) {
                    const std::uint32_t a = at(0, seed), b = at(other, seed);
                    ++counts.at(a * (n - 1) + (b > a ? b - 1 : b));
                }
                return evenness(counts);
            };
            CHECK(places_of([&](std::uint32_t i, std::uint64_t k) { return permuted(i, n, scramble(k)); }) >
                  alpha);
            CHECK(places_of([&](std::uint32_t i, std::uint64_t k) { return std::uint32_t((i + k) % n); }) <
                  alpha);
        }
}

TEST_CASE("halton: digits are mirrored, and b^k numbers in a row share out the unit interval") {
    CHECK(radical_inverse(2, 1) == 0.5);
    CHECK(radical_inverse(2, 6) == 0.375);    // 110 in base 2: 0.011
    CHECK(radical_inverse(3, 5) == 7.0 / 9);  // 12 in base 3: 0.21
    CHECK(radical_inverse(10, 1234) == 0.4321);
    for (const std::uint32_t b : {2U, 3U, 5U, 7U})
        for (const std::uint64_t start : {0U, 1U, 1000U}) {
            std::set<int>       intervals;
            const std::uint64_t end = start + std::uint64_t{b} * b * b;
            for (std::uint64_t i = start; i < end; ++i)
                intervals.insert(int(radical_inverse(b, i) * b * b * b + 1e-9));
            CHECK(intervals.size() == b * b * b);
        }
}

TEST_CASE("sobol: the first eight points of three dimensions, as published") {
    std::set<std::array<double, 3>> found;
    for (std::uint32_t i = 0; i < 8; ++i)
        found.insert({sobol(i, 0) * 0x1p-32, sobol(i, 1) * 0x1p-32, sobol(i, 2) * 0x1p-32});
    CHECK(found == std::set<std::array<double, 3>>{{0, 0, 0},
                                                   {0.5, 0.5, 0.5},
                                                   {0.75, 0.25, 0.25},
                                                   {0.25, 0.75, 0.75},
                                                   {0.375, 0.375, 0.625},
                                                   {0.875, 0.875, 0.125},
                                                   {0.625, 0.125, 0.875},
                                                   {0.125, 0.625, 0.375}});
}

TEST_CASE("sobol: property A, one point in each of the 2^d parts of the cube, up to 21 dimensions") {
    const auto parts = [](std::size_t d, const auto& coordinate) {
        std::vector<bool> found(std::size_t{1} << d);
        for (std::uint32_t i = 0; i < found.size(); ++i) {
            std::size_t part = 0;
            for (std::size_t k = 0; k < d; ++k) part = part << 1 | coordinate(i, k) >> 31;
            found[part] = true;
        }
        return std::count(found.begin(), found.end(), true);
    };
    for (std::size_t d = 1; d <= sobol_dimensions; ++d) CHECK(parts(d, sobol) == 1L << d);
    const auto repeated = [](std::uint32_t i, std::size_t k) { return sobol(i, k == 9 ? 8 : k); };
    CHECK(parts(10, repeated) < 1L << 10);
}

TEST_CASE("sobol: each coordinate shares out its axis, and the first two the square, in any blocks of 2^k") {
    for (std::size_t d = 0; d < sobol_dimensions; ++d)
        for (const std::uint32_t start : {0U, 256U, 0x12345600U}) {
            std::set<std::uint32_t> intervals;
            for (std::uint32_t i = start; i < start + 256; ++i) intervals.insert(sobol(i, d) >> 24);
            CHECK(intervals.size() == 256);
        }
    std::vector<Vector2<double>> first, others;
    for (std::uint32_t i = 512; i < 1024; ++i) {
        first.emplace_back(sobol(i, 0) * 0x1p-32, sobol(i, 1) * 0x1p-32);
        others.emplace_back(sobol(i, 4) * 0x1p-32, sobol(i, 7) * 0x1p-32);
    }
    CHECK(is_net(first));
    CHECK_FALSE(is_net(others));
}

TEST_CASE("owen: numbers with k bits in common keep k in common, and all of them are turned over at random") {
    for (const std::uint32_t seed : {0U, 1U, 0xdeadbeefU})
        for (int k = 0; k < 32; ++k) {
            const std::uint32_t v = 0x9e3779b9,
                                w = v ^ 1U << (31 - k) ^ (k < 31 ? 0x5bd1e995U & ((1U << (31 - k)) - 1) : 0);
            CHECK(std::countl_zero(owen_scrambled(v, seed) ^ owen_scrambled(w, seed)) == k);
        }
}

/// By the hash that the scrambling's was made from.
/// @see Laine and Karras, Stratified Sampling for Stochastic Transparency (2011)
std::uint32_t laine_karras(std::uint32_t bits, std::uint32_t seed) {
    std::uint32_t v = reversed_bits(bits) + seed;
    for (const std::uint32_t factor : {0x6c50b47cU, 0xb82f1e52U, 0xc7afe638U, 0x8d22f6e6U}) v ^= v * factor;
    return reversed_bits(v);
}

TEST_CASE("owen: what happens to any two intervals is independent, which the hash before this one missed") {
    // the tree of the first four bits has 15 nodes: whether each is turned over, for many seeds
    const auto dependent_pairs = [](const auto& scrambled) {
        constexpr int                       seeds = 20000;
        std::vector<std::array<double, 15>> turned(seeds);
        for (std::size_t n = 0; n < seeds; ++n) {
            std::size_t node = 0;
            for (int bits = 0; bits < 4; ++bits)
                for (std::uint32_t prefix = 0; prefix < 1U << bits; ++prefix) {
                    const std::uint32_t start = bits == 0 ? 0 : prefix << (32 - bits);
                    const std::uint32_t after = scrambled(start, std::uint32_t(hash(1, n)));
                    turned[n].at(node++)      = (after >> (31 - bits) & 1) != 0 ? 1 : -1;
                }
        }
        int dependent = 0;
        for (std::size_t i = 0; i < 15; ++i)
            for (std::size_t j = 0; j <= i; ++j) {  // with i itself: whether it is turned over at all
                double sum = 0;
                for (const auto& of : turned) sum += i == j ? of[i] : of[i] * of[j];
                dependent += z_test(sum / seeds, 1 / std::sqrt(double(seeds)), 0).p > alpha / 120 ? 0 : 1;
            }
        return dependent;
    };
    CHECK(dependent_pairs(owen_scrambled) == 0);
    CHECK(dependent_pairs(laine_karras) > 10);
    CHECK(dependent_pairs([](std::uint32_t v, std::uint32_t seed) { return v ^ seed; }) > 10);
}

TEST_CASE("patterns: each sample's numbers are uniform, and so are their pairs") {
    CHECK(evenness_over_seeds<RandomPoint>() > alpha);
    CHECK(evenness_over_seeds<StratifiedPoint>() > alpha);
    CHECK(evenness_over_seeds<HaltonPoint>() > alpha);
    CHECK(evenness_over_seeds<SobolPoint>() > alpha);
}

TEST_CASE("patterns: samples of a pixel share out each pair's square as they say") {
    const auto strata = [](const std::vector<Vector2<double>>& points) {
        std::set<std::pair<int, int>> squares;
        for (const auto& p : points) squares.insert({int(p.x * 16), int(p.y * 16)});
        return squares.size();
    };
    for (const int skipped : {0, 1, 2, 7}) {
        CHECK(strata(pairs<StratifiedPoint>(256, skipped)) == 256);
        CHECK(
            is_net(pairs<SobolPoint>(256, 2 * skipped)));  // the first pair of a set of four; of the second,
        CHECK(strata(pairs<SobolPoint>(256, 2 * skipped + 1)) >= 128);  // at most two points share a box
        CHECK(strata(pairs<RandomPoint>(256, skipped)) < 200);          // 256 (1 - 1/e) = 162 +- 5
        CHECK_FALSE(is_net(pairs<StratifiedPoint>(256, skipped)));
    }
}

TEST_CASE("patterns: a pixel's numbers by Halton's points share out intervals of any place, moved or not") {
    // of the third number, of base 5: 125 samples in a row have one in each interval of 1/125, if these are moved as well
    std::set<int> intervals;
    const auto    third = [](std::uint32_t i) {
        HaltonPoint point({.seed = 9, .x = 1, .y = 2, .index = i, .count = 250});
        static_cast<void>(point.pair<double>());
        return point.number<double>();
    };
    const double moved = third(0);
    for (std::uint32_t i = 125; i < 250; ++i) {
        const double back = third(i) - moved;
        intervals.insert(int(std::floor((back < 0 ? back + 1 : back) * 125 + 1e-6)));
    }
    CHECK(intervals.size() == 125);
}

TEST_CASE("patterns: strata of single numbers, also in float, and only square numbers of pairs") {
    constexpr std::uint32_t n = 4096;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        std::set<std::uint32_t> strata;
        for (std::uint32_t i = 0; i < n; ++i) {
            StratifiedPoint point({.seed = seed, .x = 3, .y = 4, .index = i, .count = n});
            strata.insert(std::uint32_t(point.number<float>() * n));
        }
        CHECK(strata.size() == n);
    }
    StratifiedPoint five({.index = 2, .count = 5});
    CHECK(five.number<double>() < 1);
    CHECK_THROWS_WITH(static_cast<void>(five.pair<double>()),
                      "5 samples can't be stratified in pairs; must be a square number, 1, 4, 9, ...");
}

TEST_CASE("patterns: which strata of one pair and of the next go together is random") {
    // from one pair's half to the other's: 8 x 8 cells of (x of pair a, x of pair b), over seeds
    const auto together = [](int a, int b, auto&& points) {
        std::vector<std::uint64_t> counts(64);
        for (std::uint64_t seed = 0; seed < 100; ++seed) {
            const auto first = points(a, seed), second = points(b, seed);
            for (std::size_t i = 0; i < first.size(); ++i)
                ++counts.at(std::size_t(first[i].x * 8) + 8 * std::size_t(second[i].x * 8));
        }
        return evenness(counts);
    };
    const auto stratified = [](int skipped, std::uint64_t seed) {
        return pairs<StratifiedPoint>(64, skipped, seed);
    };
    const auto sobol_sets = [](int skipped, std::uint64_t seed) {
        return pairs<SobolPoint>(64, skipped, seed);
    };
    CHECK(together(0, 1, stratified) > alpha);
    CHECK(together(0, 2, sobol_sets) > alpha);
    CHECK(together(1, 2, sobol_sets) > alpha);
    CHECK(together(0, 0, sobol_sets) < alpha);
}
