/// @file radiosity_relaxation.cpp
/// For which lambda relaxed Jacobi converges, and how fast: oracles C4 and D13 to D17.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "../../chapters/08_radiosity/known_systems.hpp"
#include "../../chapters/08_radiosity/steps_to_a_millionth.hpp"
#include "near.hpp"
#include "radiosity/relaxation.hpp"
#include "radiosity/relaxed_jacobi.hpp"

using namespace sr;
using sr::test::near;

TEST_CASE("C4: the eigenvalues of a cube's form factors: 1, three of -f_o, two of f_o - 2 f_a") {
    constexpr double    rho = 0.5;
    std::vector<double> found;  // mu is 1 - rho times an eigenvalue of F
    for (const auto& mu : jacobi_eigenvalues(cube_of_faces(std::vector<GreyPatch>(6, {rho, 1})))) {
        CHECK(std::abs(mu.imag()) <= 1e-14);
        found.push_back((1 - mu.real()) / rho);
    }
    std::sort(found.begin(), found.end());
    const double across = -0.19982489569838738, beside = -0.20026265645241893;
    const double expected[] = {beside, beside, across, across, across, 1};
    REQUIRE(found.size() == 6);
    for (std::size_t i = 0; i < 6; ++i) CHECK(found[i] == near(expected[i], 1e-13));
}

TEST_CASE("D13: two plates, the spectral radius of a step") {
    struct Row {
        double rho, half, one, more;
    };
    for (const auto& [rho, half, one, more] :
         {Row{0.5, 0.75, 0.5, 0.575}, {0.9, 0.95, 0.9, 0.995}, {0.99, 0.995, 0.99, 1.0895}}) {
        CAPTURE(rho);
        const auto mu = jacobi_eigenvalues(two_plates({rho, 1}, {rho, 1}));
        CHECK(spectral_radius(mu, 0.5) == near(half, 1e-12));
        CHECK(spectral_radius(mu, 1) == near(one, 1e-12));
        CHECK(spectral_radius(mu, 1.05) == near(more, 1e-12));
        CHECK(best_lambda(mu) == near(1, 1e-12));
    }
}

TEST_CASE("D14: two plates, the largest stable lambda: exact, estimated, and safe") {
    struct Row {
        double first, second, bound;
    };
    for (const auto& [first, second, bound] : {Row{0.5, 0.5, 1.3333333333333333},
                                               {0.9, 0.9, 1.0526315789473684},
                                               {0.99, 0.99, 1.0050251256281407},
                                               {0.999, 0.999, 1.0005002501250625},
                                               {0.3, 0.8, 1.342373819587801}}) {
        CAPTURE(bound);
        const auto system = two_plates({first, 1}, {second, 1});
        CHECK(largest_stable_lambda(jacobi_eigenvalues(system)) == near(bound, 1e-10));
        CHECK(estimated_stable_lambda(system) == near(bound, 1e-6));
        CHECK(safe_lambda(system) <= bound * (1 + 1e-15));
        CHECK(safe_lambda(system) >= 1);
        CHECK_THROWS_AS(check_relaxation(system, bound * (1 + 1e-9)), std::invalid_argument);
        CHECK_NOTHROW(check_relaxation(system, 0.99 * bound));
    }
}

TEST_CASE("D15: two plates, the number of steps to a millionth of the error") {
    struct Row {
        double rho, lambda;
        int    steps;
    };
    for (const auto& [rho, lambda, steps] : {Row{0.5, 0.5, 49},
                                             {0.5, 1, 20},
                                             {0.5, 1.05, 19},
                                             {0.9, 0.5, 270},
                                             {0.9, 1, 132},
                                             {0.9, 1.05, 125},
                                             {0.99, 0.5, 2757},
                                             {0.99, 1, 1375},
                                             {0.5, 1.3, 14}}) {
        CAPTURE(rho);
        CAPTURE(lambda);
        const auto system = two_plates({rho, 1}, {rho, 1});
        CHECK(steps_to_a_millionth(system, RelaxedJacobi(system, lambda)) == steps);
    }
}

TEST_CASE("D16: a cube of six faces, the stable range and the best lambda") {
    struct Row {
        double rho, bound, best, radius;
    };
    for (const auto& [rho, bound, best, radius] :
         {Row{0.5, 1.8179647726464519, 1.2498974082440197, 0.37505129587799015},
          {0.9, 1.6945757778508908, 1.5622114902850237, 0.84377885097149763},
          {0.99, 1.6690868009568119, 1.6552728307875622, 0.98344727169212438}}) {
        CAPTURE(rho);
        const auto system = cube_of_faces(std::vector<GreyPatch>(6, {rho, 1}));
        const auto mu     = jacobi_eigenvalues(system);
        CHECK(largest_stable_lambda(mu) == near(bound, 1e-10));
        CHECK(best_lambda(mu) == near(best, 1e-10));
        CHECK(spectral_radius(mu, best) == near(radius, 1e-10));
        // The largest two eigenvalues differ by 0.0004: the power method would take thousands of steps to part them.
        CHECK(estimated_stable_lambda(system) == near(bound, 1e-3));
        // That is enough to let pass what grows, if slowly: half a per cent is kept away from it.
        for (const double share : {0.9999, 1.0001, 1.00014})
            CHECK_THROWS_AS(RelaxedJacobi(system, share * bound), std::invalid_argument);
        CHECK_NOTHROW(RelaxedJacobi(system, 0.99 * bound));
    }
}

TEST_CASE("D17: the inside of a sphere in equal pieces, which see themselves") {
    struct Row {
        std::size_t n;
        double      bound, radius;
    };
    for (const auto& [n, bound, radius] :
         {Row{1, 2, 0}, {2, 1.1, 0.81818181818181818}, {8, 1.775, 0.88732394366197183}}) {
        CAPTURE(n);
        const auto system = inside_of_a_sphere(std::vector<GreyPatch>(n, {0.9, 1}));
        const auto mu     = jacobi_eigenvalues(system);
        CHECK(largest_stable_lambda(mu) == near(bound, 1e-10));
        CHECK(spectral_radius(mu, 1) == doctest::Approx(radius).epsilon(1e-12));
        CHECK(estimated_stable_lambda(system) == near(bound, 1e-6));
        CHECK(safe_lambda(system) <= bound * (1 + 1e-15));
        CHECK(safe_lambda(system) >= 1);
    }
}

TEST_CASE("the eigenvalues of factors that are not reciprocal may be complex, and the bound holds for them") {
    // Three patches that send all their light around in a circle: mu = 1 - rho times the third roots of 1.
    const auto   circle = grey_system({{0.8, 1}, {0.8, 1}, {0.8, 1}},
                                      [](std::size_t i, std::size_t j) { return j == (i + 1) % 3 ? 1 : 0; });
    const auto   mu     = jacobi_eigenvalues(circle);
    const double bound = 2 * 1.4 / (1 + 0.8 + 0.64);  // 2 Re mu / |mu|^2 of mu = 1 + rho/2 +- i rho sqrt(3)/2
    CHECK(largest_stable_lambda(mu) == near(bound, 1e-12));
    CHECK(spectral_radius(mu, bound) == near(1, 1e-12));
    CHECK(largest_stable_lambda({1, {-0.1, 2}}) == 0);  // the error along the second grows with any step
}

TEST_CASE("a lambda that is not stable is refused, with the bound") {
    const auto system = two_plates({0.9, 1}, {0.9, 0});
    CHECK_NOTHROW(RelaxedJacobi(system, 1.05));
    CHECK_THROWS_WITH_AS(
        RelaxedJacobi(system, 1.06),
        "lambda is 1.06; must be above 0 and below 1.053, or the steps of relaxed Jacobi grow",
        std::invalid_argument);
    CHECK_THROWS_AS(RelaxedJacobi(system, 0), std::invalid_argument);
    const auto bright = two_plates({1, 1}, {0.999, 0});
    CHECK_NOTHROW(RelaxedJacobi{bright});  // whose bound is 1.0003
    CHECK_THROWS_AS(RelaxedJacobi(system, -0.5), std::invalid_argument);
    CHECK_THROWS_AS(RelaxedJacobi(system, std::nan("")), std::invalid_argument);
}

TEST_CASE("nothing is known of eigenvalues of which one is NaN, wherever it is") {
    const double nan = std::nan("");
    for (const Eigenvalues& lost :
         {Eigenvalues{nan, 1, 0.5}, Eigenvalues{1, nan, 0.5}, Eigenvalues{1, 0.5, nan}}) {
        CHECK(std::isnan(spectral_radius(lost, 1)));
        CHECK(std::isnan(largest_stable_lambda(lost)));
        CHECK(std::isnan(best_lambda(lost)));
    }
}
