/// @file form_factors.cpp
/// Form factors of patches that touch, that are near, and that are far: rows S27, S28, S29 and S30. And rows that do
/// not add up to 1: S38. The textbook's forms are those that chapter 8 charts.

#include <doctest/doctest.h>

#include <cmath>
#include <tuple>

#include "../../chapters/08_radiosity/closure_chart.hpp"
#include "../../chapters/08_radiosity/textbook_factors.hpp"
#include "../../chapters/08_radiosity/touching_patches.hpp"
#include "near.hpp"
#include "radiosity/system_check.hpp"

using namespace sr;
using test::near;

TEST_CASE(
    "S27: squares that touch, as points, are wrong by 59 %, and by half as much in pieces half as large") {
    const Patch  from = level_square(), to = upright_square();
    const double exact = 0.20004377607540315;
    for (const auto& [n, points, disks] : {std::tuple{1, 0.591, -0.028},
                                           {2, 0.320, -0.044},
                                           {4, 0.165, -0.036},
                                           {8, 0.083, -0.023},
                                           {16, 0.042, -0.013},
                                           {32, 0.021, -0.007}}) {
        CAPTURE(n);
        CHECK(std::abs(summed_over_pieces(from, to, n, point_form_factor) / exact - 1 - points) <= 6e-4);
        CHECK(std::abs(summed_over_pieces(from, to, n, disk_form_factor) / exact - 1 - disks) <= 6e-4);
    }
    CHECK(exchange_area(from, to, 1e-6) == near(exact, 1e-6));
    // the cure knows the contour; a point that is wrong by 2 % after a million pairs does not
    CHECK(std::abs(summed_contours(from, to, 32) / exact - 1) <= 1e-3);
}

TEST_CASE("S28: of near squares, middle to middle, the form factor is above 1") {
    for (const auto& [distance, textbook, exact] : {std::tuple{1.0, 0.3183, 0.199825},
                                                    {0.5, 1.273, 0.415253},
                                                    {0.1, 31.83, 0.826995},
                                                    {0.01, 3183.0, 0.980417}}) {
        CAPTURE(distance);
        const Patch from = level_square(), to = level_square(distance).reversed();
        CHECK(point_form_factor(from, to) == near(textbook, 5e-4));
        CHECK(disk_form_factor(from, to) <= 1);
        CHECK(opposed_rectangles(1, 1, distance) == near(exact, 2e-6));
        CHECK(exchange_area(from, to, 1e-5) == near(exact, 1.2e-5));
    }
}

TEST_CASE("S29: Hottel's formula for distant squares loses its digits, in float from 100 sides on") {
    for (const auto& [distance, exact, in_float, in_double] :
         {std::tuple{10.0, 0.003162056839, 0.00316, 0.0031620568},
          {1e2, 3.182886673e-05, 0.0, 3.1828866e-05},
          {1e3, 3.18309674e-07, 0.0, 3.1833861e-07},
          {1e4, 3.183098841e-09, 0.0, 0.0}}) {
        CAPTURE(distance);
        CHECK(std::abs(double(textbook_opposed_squares(float(distance))) - in_float) <= 1e-3 * in_float);
        CHECK(std::abs(textbook_opposed_squares(distance) - in_double) <= 1e-6 * in_double);
        CHECK(opposed_rectangles(1, 1, distance) == near(exact, 1e-9));
        const Patch from = level_square(), to = level_square(distance).reversed();
        CHECK(exchange_area(from, to) == near(exact, 1e-6));
    }
}

TEST_CASE("S30: the disks' root with the minus sign is 0 from afar") {
    for (const auto& [distance, exact, in_float, in_double] :
         {std::tuple{10.0, 0.0098048641, 0.009808, 0.00980486},
          {1e2, 9.9980005e-05, 0.0, 9.998e-05},
          {1e4, 9.9999998e-09, 0.0, 7.45058e-09},
          {1e8, 1e-16, 0.0, 0.0}}) {
        CAPTURE(distance);
        CHECK(std::abs(double(textbook_unit_disks(float(distance))) - in_float) <= 1e-3 * in_float);
        CHECK(std::abs(textbook_unit_disks(distance) - in_double) <= 1e-5 * in_double);
        CHECK(coaxial_disks(1, 1, distance) == near(exact, 1e-8));
    }
}

TEST_CASE("S38: rows that add up to 1 + e give B = 1 / (1 - rho (1 + e)); scaled, they give 1 / (1 - rho)") {
    for (const auto& [rho, e, B] : {std::tuple{0.5, -0.020, 1.9608},
                                    {0.5, -0.005, 1.99},
                                    {0.5, 0.005, 2.0101},
                                    {0.5, 0.020, 2.0408},
                                    {0.9, -0.020, 8.4746},
                                    {0.9, -0.005, 9.5694},
                                    {0.9, 0.005, 10.471},
                                    {0.9, 0.020, 12.195},
                                    {0.99, -0.020, 33.557},
                                    {0.99, -0.005, 66.89},
                                    {0.99, 0.005, 198.02}}) {
        CAPTURE(rho);
        CAPTURE(e);
        const auto F = cube_with_defect(e);
        CHECK(radiosity_in_cube(F, rho) == near(B, 3e-5));
        CHECK(radiosity_in_cube(symmetrically_scaled(F), rho) == near(1 / (1 - rho), 1e-10));
        CHECK(radiosity_in_cube(with_normalised_rows(F), rho) == near(1 / (1 - rho), 1e-10));
    }
    // The last row: 0.99 (1 + 0.02) is above 1, and bounces have no end. What solves the equations is no light:
    // refused.
    const auto            F      = cube_with_defect(0.02);
    const RadiositySystem bright = grey_system(std::vector<GreyPatch>(6, {0.99, 1}),
                                               [&](std::size_t i, std::size_t j) { return F(i, j); });
    CHECK(radiosity_in_cube(F, 0.99) == near(1 / (1 - 0.99 * 1.02), 1e-9));
    CHECK(radiosity_in_cube(F, 0.99) < 0);
    CHECK_THROWS_AS(check_system(bright, 0.03), std::invalid_argument);
}
