/// @file convex_bodies.cpp
/// Line statistics of convex bodies: what the surface-area heuristic stands on. Oracles G6 to G10.

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "../../chapters/04_boxes/chords.hpp"
#include "statistics/tests.hpp"

using namespace sr;

namespace {

// |z| <= 5 for each of some 30 estimates with a fixed seed: chance alone fails in one of 60 000 such tests.
constexpr double alpha = 5.7e-7;
const Draw       draw{.lines = 400'000, .seed = 4, .threads = 0};

double p_of(const Running& estimate, double expected) {
    return z_test(estimate.mean(), estimate.standard_error(), expected).p;
}

}  // namespace

TEST_CASE("G6 to G8, G10: chords of convex bodies, and their mean shadow") {
    struct Row {
        ConvexBody body;
        double     chord, fourth, shadow;  // 4 V / S, 12 V^2 / (pi S), S / 4
    };
    // A tetrahedron of edge 1 stands in a cube of side 1 / sqrt(2).
    for (const auto& [body, chord, fourth, shadow] :
         {Row{ball_body(1), 1.3333333333333333, 5.3333333333333333, 3.1415926535897932},
          {box_body("cube", {1, 1, 1}), 0.66666666666666667, 0.63661977236758134, 1.5},
          {box_body("box", {1, 2, 3}), 1.0909090909090909, 6.250448674154435, 5.5},
          {tetrahedron_body(1 / std::numbers::sqrt2), 0.27216552697590868, 0.030629383078988447,
           0.43301270189221932},
          {cylinder_body(1, 2), 1.3333333333333333, 8.0, 4.71238898038469}}) {
        CAPTURE(body.name);
        CHECK(std::abs(4 * body.volume / body.surface / chord - 1) <= 1e-14);
        const auto chords = measure_chords(body, draw);
        CHECK(p_of(chords.length, chord) > alpha);
        CHECK(p_of(chords.fourth, fourth) > alpha);
        CHECK(p_of(chords.length, 1.02 * chord) < alpha);  // and a chord that is 2 % longer is noticed
        CHECK(p_of(chords.fourth, 1.05 * fourth) < alpha);
        const double disk = std::numbers::pi * body.circumradius * body.circumradius;
        // All lines through its own sphere meet a ball: nothing is left to chance.
        if (body.ball > 0)
            CHECK(mean_shadow(chords, body) == doctest::Approx(shadow).epsilon(1e-14));
        else
            CHECK(p_of(chords.met, shadow / disk) > alpha);
    }
    CHECK(p_of(measure_chords(ball_body(1), draw).square, 2) > alpha);
    CHECK(p_of(measure_chords(box_body("cube", {1, 1, 1}), draw).square, 0.59775574359273374) > alpha);
}

TEST_CASE("G9: a line that meets a convex body meets one inside with the ratio of the surfaces") {
    struct Row {
        ConvexBody inner, outer;
        double     chance;
    };
    const auto cube = box_body("cube", {1, 1, 1});
    for (const auto& [inner, outer, chance] :
         {Row{ball_body(0.5), cube, 0.52359877559829887},
          {tetrahedron_body(1), cube, 0.57735026918962576},
          {cube, ball_body(std::numbers::sqrt3 / 2), 0.63661977236758134}}) {
        CAPTURE(inner.name);
        CHECK(std::abs(inner.surface / outer.surface / chance - 1) <= 1e-14);
        const auto met = measure_nested(inner, outer, draw);
        CHECK(p_of(met, chance) > alpha);
        CHECK(p_of(met, chance + 0.01) < alpha);
    }
}
