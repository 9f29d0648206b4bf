/// @file main.cpp
/// Chapter 9, Monte Carlo: integrals as means of random samples, how wrong they are, and how to be less wrong.

#include "adaptive_charts.hpp"
#include "convergence.hpp"
#include "convergence_charts.hpp"
#include "course/chapter.hpp"
#include "density_charts.hpp"
#include "density_claims.hpp"
#include "density_race.hpp"
#include "dimensions.hpp"
#include "dimensions_charts.hpp"
#include "estimators.hpp"
#include "firefly_figures.hpp"
#include "heavy_tail_charts.hpp"
#include "hemisphere_charts.hpp"
#include "inversions.hpp"
#include "overhead_chart.hpp"
#include "point_diagrams.hpp"
#include "point_sets.hpp"
#include "rejection_charts.hpp"
#include "rejection_cost.hpp"
#include "seed_figures.hpp"
#include "sum_charts.hpp"
#include "variances.hpp"

namespace sr {
namespace {

/// 9.1  How is an integral a mean?
void estimators(course::Chapter& chapter) {
    chapter.section("9.1 The estimator");
    show_sample_sizes(chapter);
    chart_running_means(chapter);
    show_standard_errors(chapter);
    show_errors(chapter);
    show_hit_or_miss(chapter);
}

/// 9.2  What does light from everywhere add up to?
void hemispheres(course::Chapter& chapter) {
    chapter.section("9.2 Over a hemisphere");
    show_directions(chapter);
    chart_powers(chapter);
    chart_caps(chapter);
}

/// 9.3  How does a uniform number become one of any density?
void inversion(course::Chapter& chapter) {
    chapter.section("9.3 Drawing from a density: inversion");
    claim_generators(chapter);
    show_inversion(chapter);
    claim_triangle(chapter);
    show_numeric_inversion(chapter);
    claim_ends(chapter);
    claim_samplers(chapter);
}

/// 9.4  And where the integral has no formula?
void rejection(course::Chapter& chapter) {
    chapter.section("9.4 Drawing from a density: rejection");
    chart_rejection(chapter);
    chart_trials(chapter);
    claim_variance_of_trials(chapter);
    claim_lobes(chapter);
    chart_clipped(chapter);
    claim_noticed(chapter);
    chart_rejection_time(chapter);
}

/// 9.5  Which density has the least variance?
void densities(course::Chapter& chapter) {
    chapter.section("9.5 Which density?");
    chart_what_counts(chapter);
    chart_exponents(chapter);
    claim_squares(chapter);
    claim_unseen(chapter);
    claim_two_lamps(chapter);
    claim_control_variates(chapter);
    claim_two_densities(chapter);
    chart_overhead_lamp(chapter);
    claim_overhead_lamp(chapter);
    const auto laps = race_densities(chapter.options().threads);
    claim_densities(chapter, laps);
    chart_densities(chapter, laps);
}

/// 9.6  Must samples be independent?
void patterns(course::Chapter& chapter) {
    chapter.section("9.6 Points that know of each other");
    claim_jitter(chapter);
    claim_antithetic_pairs(chapter);
    const auto sets = six_point_sets(64);
    draw_patterns(chapter, sets);
    draw_net(chapter);
    draw_scrambling(chapter);
    claim_boxes(chapter, sets);
    claim_scrambled_mean(chapter);
}

/// 9.7  How fast does the error fall?
void convergence(course::Chapter& chapter) {
    chapter.section("9.7 Error against samples, and against time");
    const auto&       options = chapter.options();
    const SampleRange range{options.quality == course::Quality::draft ? last_fitted : 16, options.threads};
    const auto        smooth = run_patterns(1, range, Bump{}), edge = run_patterns(5, range, HalfPlane{});
    chart_convergence(
        {chapter, "", "a bump, smooth", {{"$n^{-1/2}$", 0.5}, {"$n^{-1}$", 1}, {"$n^{-3/2}$", 1.5}}}, smooth,
        options.quality);
    chart_convergence({chapter, "_edge", "an oblique edge", {{"$n^{-1/2}$", 0.5}, {"$n^{-3/4}$", 0.75}}},
                      edge, options.quality);
    claim_convergence(chapter, smooth, edge);
}

/// 9.8  What do edges and dimensions do to that?
void dimensions(course::Chapter& chapter) {
    chapter.section("9.8 Edges and dimensions");
    const int  threads = chapter.options().threads;
    const auto smooth  = run_dimensions(1, threads, SineProduct{}),
               ball    = run_dimensions(4, threads, BallPart{});
    chart_dimensions(chapter, "dimensions_smooth", "A smooth product",
                     "Gauss's rule errs by less than $10^{-12}$ in up to four dimensions.", smooth);
    chart_dimensions(
        chapter, "dimensions_ball", "A ball in its cube",
        "An edge, which one dimension has not: what is left of Gauss's rule is luck, and of the grid's "
        "advantage little. In 12, hardly a point would be in the ball.",
        ball);
    claim_dimensions(chapter, smooth, ball);
}

/// 9.9  Can a program tell where to sample more, and when to stop?
void adaptive(course::Chapter& chapter) {
    chapter.section("9.9 Samples where they are needed");
    claim_strata(chapter);
    render_adaptive(chapter);
    claim_adaptive(chapter);
    chart_stopping(chapter);
    claim_stopping(chapter);
}

/// 9.10  What can't be trusted?
void failures(course::Chapter& chapter) {
    chapter.section("9.10 Where it fails");
    chart_jumps(chapter);
    chart_heavy_tails(chapter);
    claim_clamped(chapter);
    render_small_lamp(chapter);
    claim_rare_hits(chapter);
    chart_sums(chapter);
    claim_sums(chapter);
    render_seeds(chapter);
    claim_seeds(chapter);
}

}  // namespace
}  // namespace sr

int main(int argc, char** argv) {
    using namespace sr;
    const course::Defaults defaults{.takes_seed = false};
    return course::run(argc, argv, "09_monte_carlo", "Monte Carlo", defaults, [](course::Chapter& chapter) {
        estimators(chapter);
        hemispheres(chapter);
        inversion(chapter);
        rejection(chapter);
        densities(chapter);
        patterns(chapter);
        convergence(chapter);
        dimensions(chapter);
        adaptive(chapter);
        failures(chapter);
    });
}
