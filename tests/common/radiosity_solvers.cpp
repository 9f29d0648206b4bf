/// @file radiosity_solvers.cpp
/// Every solver against known solutions (oracles D1-D4, D6, D9, D10, D18), against each other, and on any number of
/// threads.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "../../chapters/08_radiosity/known_systems.hpp"
#include "law.hpp"
#include "math/extremes.hpp"
#include "near.hpp"
#include "radiosity/conjugate_gradients.hpp"
#include "radiosity/direct_solution.hpp"
#include "radiosity/gauss_seidel.hpp"
#include "radiosity/progressive_shooting.hpp"
#include "radiosity/reciprocity.hpp"
#include "radiosity/relaxation.hpp"
#include "radiosity/relaxed_jacobi.hpp"
#include "radiosity/residual.hpp"
#include "radiosity/southwell.hpp"
#include "radiosity/system_check.hpp"
#include "sampling/rng.hpp"

using namespace sr;
using sr::test::check_law;
using sr::test::counterexample;
using sr::test::near;

namespace {

/// Solvers refer to their system: one that is gone after the line is no argument.
template <class S>
constexpr bool only_of_what_stays =
    std::is_constructible_v<S, const RadiositySystem&> && !std::is_constructible_v<S, RadiositySystem>;
static_assert(only_of_what_stays<RelaxedJacobi> && only_of_what_stays<GaussSeidel> &&
              only_of_what_stays<Southwell> && only_of_what_stays<ProgressiveShooting> &&
              only_of_what_stays<ConjugateGradients>);

template <RadiositySolver S>
Radiosities solved(S solver) {
    const Convergence told = solve(solver, 1e-13, 1'000'000);
    CHECK(told.reached);
    return solver.radiosities();
}

struct NamedSolver {
    std::string                                        name;
    std::function<Radiosities(const RadiositySystem&)> solve;
};

const std::vector<NamedSolver> all_solvers{
    {"direct", [](const auto& system) { return direct_solution(system); }},
    {"Jacobi", [](const auto& system) { return solved(RelaxedJacobi(system)); }},
    {"Jacobi, relaxed", [](const auto& system) { return solved(RelaxedJacobi(system, 0.7)); }},
    {"Gauss-Seidel", [](const auto& system) { return solved(GaussSeidel(system)); }},
    {"Southwell", [](const auto& system) { return solved(Southwell(system)); }},
    {"shooting", [](const auto& system) { return solved(ProgressiveShooting(system)); }},
    {"conjugate gradients", [](const auto& system) { return solved(ConjugateGradients(system)); }},
};

/// By all solvers, to 1e-10.
void check_solution(const RadiositySystem& system, const std::vector<double>& expected) {
    check_system(system);
    REQUIRE(expected.size() == system.size());
    for (const auto& [name, solve] : all_solvers) {
        INFO(name);
        const Radiosities found = solve(system);
        for (std::size_t i = 0; i < expected.size(); ++i) {
            CAPTURE(i);
            CHECK(std::abs(found[i].r - expected[i]) <= 1e-10 * expected[i]);
            CHECK(found[i] == DoubleSpectrum{found[i].r, found[i].r, found[i].r});
        }
    }
}

std::vector<GreyPatch> alike(std::size_t n, double reflectance, double emission) {
    return std::vector<GreyPatch>(n, GreyPatch{reflectance, emission});
}

/// Reciprocal factors of n patches with random areas, rows that sum to less than 1, and what reflects and emits all
/// kinds of light, some of them none.
RadiositySystem random_system(std::uint64_t seed, std::size_t n) {
    Rng             rng{seed, 0, 0, 0};
    const auto      u = [&] { return rng.uniform<double>(); };
    RadiositySystem system{FormFactorMatrix(n), {}, {}, {}};
    for (std::size_t i = 0; i < n; ++i) system.area.push_back(0.1 + u());
    double most = 1;
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            const double exchanged    = u() < 0.3 ? 0 : u();
            system.form_factors(i, j) = exchanged / system.area[i];
            system.form_factors(j, i) = exchanged / system.area[j];
        }
    }
    for (std::size_t i = 0; i < n; ++i) most = std::max(most, system.form_factors.row_sum(i));
    for (std::size_t i = 0; i < n; ++i)
        for (auto& factor : system.form_factors.row(i)) factor /= most;
    const auto spectrum = [&](double scale) {
        DoubleSpectrum s;
        s.r = u() < 0.2 ? 0 : scale * u();
        s.g = u() < 0.2 ? 0 : scale * u();
        s.b = u() < 0.2 ? 0 : scale * u();
        return s;
    };
    for (std::size_t i = 0; i < n; ++i) system.reflectance.push_back(spectrum(0.95));
    for (std::size_t i = 0; i < n; ++i) system.emission.push_back(spectrum(10));
    return system;
}

double largest_difference(const Radiosities& a, const Radiosities& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (const double d : {a[i].r - b[i].r, a[i].g - b[i].g, a[i].b - b[i].b})
            largest = max_or_nan(largest, std::abs(d));
    return largest;
}

template <RadiositySolver S>
Radiosities after(S solver, int steps) {
    for (int i = 0; i < steps; ++i) solver.step();
    return solver.radiosities();
}

}  // namespace

TEST_CASE("D1: a closed room in which all emit 1 and reflect alike: B = 1 / (1 - rho)") {
    for (const double rho : {0.5, 0.9, 0.99}) {
        CAPTURE(rho);
        check_solution(cube_of_faces(alike(6, rho, 1)), std::vector<double>(6, 1 / (1 - rho)));
    }
}

TEST_CASE("D2: two infinite parallel plates") {
    check_solution(two_plates({0.3, 1}, {0.8, 0}), {1.3157894736842105, 1.0526315789473684});
}

TEST_CASE("D3: concentric spheres, of which the outer one sees itself") {
    check_solution(concentric_spheres(2, {0.2, 1}, {0.7, 0}), {1.0795454545454545, 0.39772727272727273});
}

TEST_CASE("D4: a cube of six reflectances, a patch for a face") {
    check_solution(cube_of_faces({{0.1, 0}, {0.2, 0}, {0.3, 0}, {0.4, 0}, {0.5, 0}, {0.6, 1}}),
                   {0.028553745330220307, 0.056010194252030836, 0.082424856742472415, 0.10786627730577122,
                    0.13228470375560799, 1.0488500943597902});
}

TEST_CASE("D6: two strips at a right angle in black surroundings") {
    check_solution(corner_of_strips({0.6, 1}, {0.6, 0}), {1.0318672784519794, 0.18133615714444637});
}

TEST_CASE("D9: the multiplier of an integrating sphere; its port is black, and so eliminated") {
    // The whole sphere gets irradiance 1 at first, of which the wall reflects 0.98: that is what it emits.
    check_solution(inside_of_a_sphere({{0.98, 0.98, 0.95}, {0, 0, 0.05}}), {14.202898550724638, 0});
}

TEST_CASE("D10: the apparent emissivity of a spherical cavity") {
    const double opening = (1 - std::cos(std::numbers::pi / 6)) / 2;
    check_solution(inside_of_a_sphere({{0.5, 0.5, 1 - opening}, {0, 0, opening}}), {0.93721827970531846, 0});
}

TEST_CASE("D18: k steps of Jacobi hold the light of fewer than k bounces") {
    const auto system = cube_of_faces(alike(6, 0.5, 1));
    for (const auto& [k, expected] : {std::pair{1, 1.0}, {5, 1.9375}, {10, 1.998046875}}) {
        for (const auto& radiosity : after(RelaxedJacobi(system), k))
            CHECK(radiosity.g == near(expected, 1e-14));
    }
    for (const double rho : {0.5, 0.9, 0.99}) {
        const auto cube = cube_of_faces(alike(6, rho, 1));
        for (const int k : {1, 2, 7, 40})
            CHECK(after(RelaxedJacobi(cube), k)[3].r == near((1 - std::pow(rho, k)) / (1 - rho), 1e-13));
    }
}

TEST_CASE("D17: a closed sphere that is one patch takes one step, for the divisor is its own light") {
    const auto system = inside_of_a_sphere({{0.9, 1, 1}});
    for (const auto& found :
         {after(RelaxedJacobi(system), 1), after(GaussSeidel(system), 1), after(Southwell(system), 1),
          after(ProgressiveShooting(system), 1), after(ConjugateGradients(system), 1)})
        CHECK(found[0].r == near(10, 1e-14));
}

TEST_CASE("all solvers agree on random reciprocal systems") {
    const auto agree = [](const NamedSolver& solver) {
        return [&] {
            const auto   seed     = *rc::gen::arbitrary<std::uint32_t>();
            const auto   n        = *rc::gen::inRange<std::size_t>(1, 12);
            const auto   system   = random_system(seed, n);
            const double rounding = 1e-10;  // and a residual of 1e-13 of 10, with a condition of 20
            RC_ASSERT(largest_difference(solver.solve(system), direct_solution(system)) <= rounding);
        };
    };
    for (const auto& solver : all_solvers) check_law(solver.name, agree(solver), 200);

    // One with F transposed is found out.
    const auto of_transposed = [](RadiositySystem system) {
        for (std::size_t i = 0; i < system.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                std::swap(system.form_factors(i, j), system.form_factors(j, i));
        return direct_solution(system);
    };
    CHECK(counterexample(agree({"transposed", of_transposed}), 200) != "");
}

TEST_CASE("no lambda is let pass with which steps grow, however slowly") {
    check_law(
        "refused from the bound on",
        [] {
            const auto seed   = *rc::gen::arbitrary<std::uint32_t>();
            const auto system = random_system(seed, *rc::gen::inRange<std::size_t>(1, 40));
            double     bound  = 2;
            for (const auto primary : {&DoubleSpectrum::r, &DoubleSpectrum::g, &DoubleSpectrum::b})
                bound = std::min(bound, largest_stable_lambda(jacobi_eigenvalues(system, primary)));
            RC_ASSERT(safe_lambda(system) <= bound * (1 + 1e-12));
            RC_ASSERT_THROWS_AS(check_relaxation(system, bound * (1 + 1e-12)), std::invalid_argument);
            check_relaxation(system, 0.99 * bound);
        },
        200);
}

TEST_CASE("the solution is the same to the bit on any number of threads") {
    const auto system = random_system(3, 200);
    CHECK(after(RelaxedJacobi(system, 1, 1), 10) == after(RelaxedJacobi(system, 1, 7), 10));
    CHECK(after(ConjugateGradients(system, 1), 5) == after(ConjugateGradients(system, 7), 5));
    CHECK(residuals(system, system.emission, 1) == residuals(system, system.emission, 0));
}

TEST_CASE("sizes of residuals are the largest of one over the largest of the other, in the worst primary") {
    const Radiosities whole{{2, 4, 0}, {-4, 1, 0}};
    CHECK(relative_size({{-3, 2, 0}, {1, 2, 0}}, whole) == near(0.75, 1e-15));
    CHECK(relative_size({{1, -1, 0}, {2, 3, 0}}, whole) == near(0.75, 1e-15));
    CHECK(relative_size({{}, {}}, whole) == 0);
    CHECK(relative_size({{0, 0, 1}, {}}, whole) == HUGE_VAL);  // where no light is emitted, any is too much
    const double nan = std::nan("");
    for (const DoubleSpectrum& lost :
         {DoubleSpectrum{nan, 0, 0}, DoubleSpectrum{0, nan, 0}, DoubleSpectrum{0, 0, nan}}) {
        CHECK(std::isnan(relative_size({lost, {1, 1, 0}}, whole)));
        CHECK(std::isnan(relative_size(whole, {lost, {1, 1, 1}})));
    }
}

TEST_CASE("a solver's residual is what the equations miss, over the largest emission") {
    check_law(
        "of Jacobi, Southwell and conjugate gradients",
        [] {
            const auto seed   = *rc::gen::arbitrary<std::uint32_t>();
            const auto system = random_system(seed, *rc::gen::inRange<std::size_t>(1, 12));
            const auto knows  = [&](auto solver, int steps) {
                for (int i = 0; i < steps; ++i) solver.step();
                const double known =
                    relative_size(residuals(system, solver.radiosities(), 1), system.emission);
                return std::abs(solver.residual() - known) <= 1e-12;
            };
            for (const int steps : {0, 1, 3}) {
                RC_ASSERT(knows(RelaxedJacobi(system, 0.7), steps));
                RC_ASSERT(knows(Southwell(system), steps));
                RC_ASSERT(knows(ConjugateGradients(system), steps));
            }
        },
        200);
    // A lamp of 4 between plates that reflect a half. Gauss and Seidel's second plate knows of it at its first turn:
    // each sweep adds two bounces. What is unshot is half as much with each shot.
    const auto          plates = two_plates({0.5, 4}, {0.5, 0});
    GaussSeidel         swept(plates);
    ProgressiveShooting shooting(plates);
    CHECK(solve(swept, 0.1, 10).residuals == std::vector<double>{1, 1, 0.25, 0.0625});
    CHECK(solve(shooting, 0.1, 10).residuals == std::vector<double>{1, 0.5, 0.25, 0.125, 0.0625});
}

TEST_CASE("a solver says how it came along, and stops at its limit, or at NaN") {
    const auto    system = two_plates({0.5, 1}, {0.5, 1});
    RelaxedJacobi solver(system);
    const auto    told = solve(solver, 1e-30, 4);
    CHECK_FALSE(told.reached);
    CHECK(told.steps() == 4);
    CHECK(told.residuals == std::vector<double>{1, 0.5, 0.25, 0.125, 0.0625});
    RelaxedJacobi as_far(system);
    const auto    enough = solve(as_far, 0.25, 4);  // no more than the tolerance, and not less
    CHECK(enough.reached);
    CHECK(enough.steps() == 2);

    const auto    broken = two_plates({0.5, std::nan("")}, {0.5, 1});
    RelaxedJacobi lost(broken);
    CHECK(solve(lost, 1e-6, 4).steps() == 0);
    CHECK_FALSE(solve(lost, 1e-6, 4).reached);

    const auto         dark = two_plates({0.5, 0}, {0.5, 0});
    ConjugateGradients easy(dark);
    CHECK(solve(easy, 1e-14, 10).steps() == 0);
    easy.step();
    CHECK(easy.radiosities()[0] == DoubleSpectrum{});
}

TEST_CASE(
    "a solution that was not reached is none: where nearly all is reflected, conjugate gradients get there") {
    // After 1000 steps of Jacobi the residual is 0.999^1000, and so much of the light is missing.
    const auto bright = cube_of_faces(alike(6, 0.999, 1));
    CHECK_THROWS_WITH_AS(
        (void)solution_by(RelaxedJacobi(bright), 1e-6, 1000),
        "the residual of the radiosities is 0.37 after 1000 steps; must be 1e-06 at most: where nearly all "
        "light is reflected, allow more steps or a larger tolerance",
        std::runtime_error);
    for (const auto& radiosity : solution_by(ConjugateGradients(bright), 1e-6, 1000))
        CHECK(radiosity.g == near(1000, 1e-9));
    const auto broken = two_plates({0.5, std::nan("")}, {0.5, 1});
    CHECK_THROWS_AS((void)solution_by(GaussSeidel(broken), 1e-6, 10), std::runtime_error);
}

TEST_CASE(
    "patches that see only themselves are solved by one step of conjugate gradients: the diagonal is divided "
    "out") {
    auto hollows = grey_system(
        alike(5, 0.9, 1), [](std::size_t i, std::size_t j) { return i == j ? 0.15 * double(i + 1) : 0; });
    ConjugateGradients solver(hollows);
    CHECK(solve(solver, 1e-13, 10).steps() == 1);
    for (std::size_t i = 0; i < 5; ++i)
        CHECK(solver.radiosities()[i].r == near(1 / (1 - 0.9 * 0.15 * double(i + 1)), 1e-13));
}

TEST_CASE("conjugate gradients end after as many steps as there are different eigenvalues") {
    // C4: of the cube's faces, alike, there are three.
    auto system        = cube_of_faces(alike(6, 0.99, 0));
    system.emission[5] = {1, 2, 3};
    ConjugateGradients solver(system);
    CHECK(solve(solver, 1e-13, 100).steps() <= 3);
}

TEST_CASE("the ambient term is the whole truth in a room of one colour that is lit evenly") {
    const auto                system = cube_of_faces(alike(6, 0.9, 1));
    const ProgressiveShooting at_once(system);
    for (const auto& radiosity : at_once.radiosities_with_ambient()) CHECK(radiosity.r == near(10, 1e-14));
    for (const auto& radiosity : at_once.radiosities()) CHECK(radiosity.r == 1);
}

TEST_CASE("the ambient term is the whole truth inside a sphere, whatever its pieces are like") {
    // All pieces get the same: H = sum A_j B_j / A, so that H = mean E + (mean rho) H, the means by area.
    const auto                system = inside_of_a_sphere({{0.2, 1, 2}, {0.7, 0, 6}});
    const double              H      = 0.25 / (1 - (0.2 + 3 * 0.7) / 4);
    const ProgressiveShooting at_once(system);
    const auto                shown = at_once.radiosities_with_ambient();
    CHECK(shown[0].b == near(1 + 0.2 * H, 1e-14));
    CHECK(shown[1].b == near(0.7 * H, 1e-14));
}

TEST_CASE("in an open scene the ambient term counts what leaves, and ends in the solution") {
    // Of what reflects all, a patch sees s of the other's light: B = 1 / (1 - s^2). At first, half of the light of 1,
    // spread over both, comes back s times, and s^2, ... times: s / 2 / (1 - s) is added.
    const auto          strips = corner_of_strips({1, 1}, {1, 0});
    const double        s      = 1 - std::sqrt(0.5);
    ProgressiveShooting shooting(strips);
    CHECK(shooting.radiosities_with_ambient()[0].r == near(1 + s / 2 / (1 - s), 1e-14));
    for (int shots = 0; shots < 500; ++shots) shooting.step();
    CHECK(shooting.radiosities_with_ambient()[0].r == near(1 / (1 - s * s), 1e-14));
}

TEST_CASE("the patch with most power shoots first, which is not the brightest one if that is small") {
    // 0.9 from four fifths of a sphere; of its own light it gets back 0.5 * 0.8 at once.
    const auto          system = inside_of_a_sphere({{0.5, 1, 1}, {0.5, 0.9, 4}});
    ProgressiveShooting shooting(system);
    shooting.step();
    const double shot = 0.9 / (1 - 0.5 * 0.8);
    CHECK(shooting.radiosities()[0].r == near(1 + 0.5 * 0.8 * shot, 1e-14));
    CHECK(shooting.radiosities()[1].r == near(shot, 1e-14));
}

TEST_CASE("Southwell's patch has the largest residual of one primary; the one that shoots, of all in sum") {
    auto system     = two_plates({0.5, 0}, {0.5, 0});
    system.emission = {{1, 0, 0}, {0.6, 0.6, 0.6}};
    CHECK(after(Southwell(system), 1) == Radiosities{{1, 0, 0}, {}});
    CHECK(after(ProgressiveShooting(system), 1) == Radiosities{{1.3, 0.3, 0.3}, {0.6, 0.6, 0.6}});
}

TEST_CASE("symmetrised factors are reciprocal, and their rows no longer sum to 1") {
    auto system = concentric_spheres(2, {0.2, 1}, {0.7, 0});
    CHECK(reciprocity_defect(system.form_factors, system.area) == 0);
    system.form_factors(0, 1) = 0.98;
    system.form_factors(0, 0) = 0.02;
    CHECK(reciprocity_defect(system.form_factors, system.area) == near(0.02, 1e-12));
    const auto mended = symmetrised(system.form_factors, system.area);
    CHECK(reciprocity_defect(mended, system.area) <= 1e-16);
    CHECK(mended.row_sum(0) == near(1.01, 1e-14));
    CHECK(mended.row_sum(1) == near(0.9975, 1e-14));
    CHECK_THROWS_WITH_AS(
        ConjugateGradients{system},
        "the form factors between patches 1 and 0 are 0.25 and 0.98 for areas 4 and 1, which is "
        "not reciprocal; make them symmetrised()",
        std::invalid_argument);
}

TEST_CASE("form factors of more patches than memory holds are refused with how much it would be") {
    CHECK_THROWS_WITH_AS(
        FormFactorMatrix{std::size_t{1} << 33},
        "the form factors between 8589934592 patches take 5.5e+11 GiB, and there is not so much memory; "
        "take fewer patches, or hierarchical_radiosity()",
        std::length_error);
    CHECK(FormFactorMatrix{3}.row(2).size() == 3);
    CHECK(FormFactorMatrix{0}.size() == 0);
}

TEST_CASE("what is not reciprocal is wrong by a share of the smaller area, either way, and never NaN") {
    auto  system = concentric_spheres(2, {0.2, 1}, {0.7, 0});
    auto& F      = system.form_factors;
    CHECK_NOTHROW(check_reciprocity(F, system.area, 0));
    F(1, 0) = 0.24;
    for (const double unit : {1.0, 0.01}) {
        const std::vector<double> area{unit, 4 * unit};
        CHECK(reciprocity_defect(F, area) == near(0.04, 1e-12));
    }
    F(1, 0) = 0.25 * (1 + 1e-8);
    CHECK_THROWS_AS(check_reciprocity(F, system.area), std::invalid_argument);
    F(1, 0) = 0.25 * (1 + 1e-10);
    CHECK_NOTHROW(check_reciprocity(F, system.area));
    F(1, 0) = std::nan("");
    CHECK(std::isnan(reciprocity_defect(F, system.area)));
    CHECK_THROWS_AS(check_reciprocity(F, system.area), std::invalid_argument);

    FormFactorMatrix three(3);
    three(1, 0) = std::nan("");  // and pairs after it are fine
    CHECK(std::isnan(reciprocity_defect(three, std::vector<double>{1, 1, 1})));
}
