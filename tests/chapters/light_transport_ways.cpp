/// @file light_transport_ways.cpp
/// Section 10.5: ways of light belong to one part each, parts sum to the picture, and three programs find the same
/// partial sums (oracle D18).

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <string>
#include <string_view>

#include "../../chapters/10_light_transport/partial_sums_chart.hpp"
#include "../../chapters/10_light_transport/parts_figures.hpp"
#include "near.hpp"

using namespace sr;
using test::near;

TEST_CASE("each way of light has its part") {
    const std::map<std::string, std::string_view> examples{
        {"LE", "the lamp"},         {"LSE", "its images"},        {"LSSSE", "its images"},
        {"LDE", "direct light"},    {"LDDE", "interreflection"},  {"LDDDDE", "interreflection"},
        {"LDSE", "images of both"}, {"LDDSSE", "images of both"}, {"LSDE", "caustics"},
        {"LSSDE", "caustics"},      {"LSDDE", "all other"},       {"LDSDE", "all other"},
        {"LSDSE", "all other"},
    };
    for (const auto& [way, part] : examples) {
        CAPTURE(way);
        CHECK(parts_of_light[part_of(way)].name == part);
        CHECK(parts_of_light[part_of(way)].name == part);  // remembered
    }
}

TEST_CASE("parts are the same for any number of threads, and sum to what paths bring") {
    const auto view  = box_of_balls(12);
    const auto parts = picture_in_parts<RandomPoint>(view, Strategy::power, hash(1, 0), 8, {1});
    const auto again = picture_in_parts<RandomPoint>(view, Strategy::power, hash(1, 0), 8, {7});
    const auto whole =
        traced<RandomPoint>(view.scene, view.camera, {}, {.seed = 1, .samples = 8}, {2}).mean();
    for (std::size_t i = 0; i < whole.pixels().size(); ++i) {
        CHECK(parts.pixels()[i].sum == again.pixels()[i].sum);
        DoubleSpectrum sum;
        for (const auto& part : parts.pixels()[i].sum) sum = sum + part / 8.0;
        const auto all = convert<double>(whole.pixels()[i]);
        CHECK(largest(magnitude(sum - all)) <= 1e-5 * (1 + largest(all)));
    }
    const auto lamp = part_of("LE"), direct = part_of("LDE");
    double     of_lamp = 0, of_direct = 0;
    for (const auto& pixel : parts.pixels()) {
        of_lamp += pixel.sum[lamp].g;
        of_direct += pixel.sum[direct].g;
    }
    CHECK(of_lamp > 0);
    CHECK(of_direct > 0);
}

TEST_CASE("D18: rays k deep, k steps of Jacobi and paths of fewer than k bounces are one sum") {
    for (const auto& program : series_programs()) {
        CAPTURE(program.name);
        for (int k = 1; k <= 20; ++k) {
            const auto L = program.sum(k);
            CHECK(L.r == near(partial_sum(0.8, k), 1e-6));
            CHECK(L.g == near(partial_sum(0.5, k), 1e-6));
            CHECK(L.b == near(partial_sum(0.2, k), 1e-6));
            CHECK_FALSE(L.g == near(partial_sum(0.5, k + 1), 1e-7));  // a bounce more
        }
    }
    CHECK(partial_sum(0.5, 1) == 1);
    CHECK(partial_sum(0.5, 5) == 1.9375);
    CHECK(partial_sum(0.5, 10) == 1.998046875);
}
