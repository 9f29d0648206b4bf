/// @file radiosity_solvers.cpp
/// Relaxed Jacobi beyond its bound, and where nearly all light is reflected: rows S35, S36 and S37.

#include <doctest/doctest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "../../chapters/08_radiosity/furnace.hpp"
#include "../../chapters/08_radiosity/known_systems.hpp"
#include "../../chapters/08_radiosity/steps_to_a_millionth.hpp"
#include "../../chapters/08_radiosity/textbook_jacobi.hpp"
#include "catalogue.hpp"
#include "near.hpp"
#include "radiosity/conjugate_gradients.hpp"
#include "radiosity/gauss_seidel.hpp"
#include "radiosity/progressive_shooting.hpp"
#include "radiosity/relaxed_jacobi.hpp"
#include "radiosity/southwell.hpp"

using namespace sr;
using test::near;
using test::within_factor_3;

namespace {

template <class Solver>
Radiosities after(Solver solver, int steps) {
    for (int i = 0; i < steps; ++i) solver.step();
    return solver.radiosities();
}

}  // namespace

TEST_CASE(
    "S35: relaxed Jacobi above its bound grows without end; it is refused, and other solvers have no bound") {
    const auto plates = two_plates({0.9, 1}, {0.9, 0});
    struct Row {
        double lambda, first, second;
    };
    for (const auto& [lambda, first, second] :
         {Row{1, 5.263, 4.737}, {1.05, 5.167, 4.833}, {1.06, 1.019, 8.981}, {1.1, -8.045e6, 8.045e6}}) {
        CAPTURE(lambda);
        const auto found = after(TextbookJacobi(plates, lambda), 200);
        CHECK(found[0].r == near(first, 5e-4));
        CHECK(found[1].r == near(second, 5e-4));
        if (lambda > 1.05) CHECK_THROWS_AS(RelaxedJacobi(plates, lambda), std::invalid_argument);
    }
    const double exact = 1 / (1 - 0.81);
    for (const auto& found :
         {after(RelaxedJacobi(plates), 200), after(GaussSeidel(plates), 200), after(Southwell(plates), 400),
          after(ProgressiveShooting(plates), 400), after(ConjugateGradients(plates), 2)}) {
        CHECK(found[0].r == near(exact, 1e-8));
        CHECK(found[1].r == near(0.9 * exact, 1e-8));
    }
}

TEST_CASE("S36: Jacobi takes 13.8 / (1 - rho) steps; conjugate gradients one, and the ambient term none") {
    struct Row {
        double rho;
        int    steps;
    };
    for (const auto& [rho, steps] :
         {Row{0.5, 20}, {0.9, 132}, {0.99, 1375}, {0.999, 13809}, {0.9999, 138149}}) {
        CAPTURE(rho);
        const auto room = cube_of_faces(std::vector<GreyPatch>(6, {rho, 1}));
        CHECK(steps_to_a_millionth(room, RelaxedJacobi(room)) == steps);
        CHECK(within_factor_3(steps, std::log(1e6) / (1 - rho)));
        CHECK(steps_to_a_millionth(room, ConjugateGradients(room)) == 1);
        CHECK(ProgressiveShooting(room).radiosities_with_ambient()[0].r == near(1 / (1 - rho), 1e-10));
    }
}

TEST_CASE("S37: B = 1 + rho B in float stops far from its solution; in double, or corrected, it does not") {
    struct Row {
        float  rho;
        double stops;
        int    steps;
    };
    for (const auto& [rho, stops, steps] : {Row{0.99F, 99.99972, 1230},
                                            {0.999F, 999.9824, 10277},
                                            {0.9999F, 9993.459, 75071},
                                            {0.99999F, 99474.29, 542182}}) {
        CAPTURE(rho);
        const double exact   = 1 / (1 - double(rho));
        const auto   stopped = furnace(rho);
        CHECK(double(stopped.radiosity) == near(stops, 1e-7));
        CHECK(stopped.steps == steps);
        CHECK(1 - stopped.radiosity / exact > 1e-6);
        // A rounding of the last step's size, times the condition 1 / (1 - rho).
        const double rounding = 1e-16 / (1 - double(rho));
        CHECK(furnace(double(rho)).radiosity == near(exact, 2 * rounding));
        CHECK(refined_furnace(rho).radiosity == near(exact, 2 * rounding));
    }
}
