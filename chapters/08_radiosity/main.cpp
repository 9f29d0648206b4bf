/// @file main.cpp
/// Chapter 8, radiosity: diffuse surfaces cut into patches, and the light that they send each other as a linear system.

#include <fmt/format.h>

#include <vector>

#include "bounces_chart.hpp"
#include "bright_rooms.hpp"
#include "closure_chart.hpp"
#include "convergence_chart.hpp"
#include "cornell_views.hpp"
#include "course/chapter.hpp"
#include "factor_charts.hpp"
#include "factor_claims.hpp"
#include "fence_chart.hpp"
#include "form_factor_diagrams.hpp"
#include "hierarchical_claims.hpp"
#include "light_leaks.hpp"
#include "limit_charts.hpp"
#include "link_diagram.hpp"
#include "lost_light.hpp"
#include "matrix_picture.hpp"
#include "mesh_strip.hpp"
#include "mirror_block.hpp"
#include "own_scene.hpp"
#include "relaxation_charts.hpp"
#include "scaling_chart.hpp"
#include "slivers.hpp"
#include "solvers_chart.hpp"
#include "surfaces_diagram.hpp"
#include "touching_patches.hpp"
#include "two_sums.hpp"

namespace sr {
namespace {

/// 8.1  What is left of the rendering equation where all is diffuse?
void radiosity_equation(course::Chapter& chapter) {
    chapter.section("8.1 From the rendering equation to radiosities");
    auto diagram = chapter.diagram("surfaces", "From directions to surfaces");
    draw_surfaces(diagram);
    diagram.caption(
        "Each direction ends on a surface; seen from $p$, its area fills a part of the directions.");

    const RoomFaces       faces{0.2, 0.4, 0.6, 0.8, 1.0};
    const Vector3<double> p{0.3, 0.4, 0};
    const auto            directions = irradiance_over_directions(faces, p, 1'000'000);
    chapter.claim("8.1 irradiance at (0.3, 0.4) from walls of 0.2, 0.4, 0.6 and 0.8, over surfaces [W/m^2]",
                  {.expected = 0.5815, .measured = irradiance_over_surfaces(faces, p), .tolerance = 5e-5});
    chapter.claim("8.1 irradiance, over directions [W/m^2]",
                  {.expected = 0.5815, .measured = directions.mean(), .tolerance = 0.0012});
    chapter.claim("8.1 its standard error [W/m^2]",
                  {.expected = 0.0003, .measured = directions.standard_error(), .tolerance = 5e-5});
}

/// 8.2  Which share of one patch's light arrives at another?
void form_factors(course::Chapter& chapter) {
    chapter.section("8.2 Form factors");
    auto two = chapter.diagram("form_factor", "Two patches");
    draw_form_factor(two);
    two.caption("What passes between two small areas: both cosines, over the square of the distance.");
    auto nusselt = chapter.diagram("nusselt", "A form factor, seen from a point");
    draw_nusselt(nusselt);
    nusselt.caption("Nusselt: onto the sphere, then straight down. The cosine is the shadow's.");
    claim_form_factors(chapter);
}

/// 8.3  How is it computed, and how wrong is that?
void computing_form_factors(course::Chapter& chapter) {
    chapter.section("8.3 Computing form factors");
    chart_near(chapter);
    chart_touching(chapter);
    auto hemicube = chapter.diagram("hemicube", "Half a cube");
    draw_hemicube(hemicube);
    hemicube.caption("What is seen through a pixel counts by what the pixel is worth.");
    claim_factor_races(chapter, chart_form_factors(chapter));
}

/// 8.4  Which equations do they make, and what if their rows don't add up to 1?
void linear_system(course::Chapter& chapter) {
    chapter.section("8.4 The linear system");
    claim_known_systems(chapter);
    claim_terms(chapter);
    chart_bounces(chapter);
    chart_closure(chapter);
    compare_closures(chapter);
}

/// 8.5  How is it solved, and how fast?
void solvers(course::Chapter& chapter) {
    chapter.section("8.5 Solving it");
    claim_two_plates(chapter);
    claim_too_large_lambda(chapter);
    claim_bounds(chapter);
    chart_lambda(chapter);
    chart_lambda_map(chapter);
    chart_solvers(chapter);
    chart_residuals(chapter);
    claim_sweeps(chapter);
    chart_ambient(chapter);
    chart_towards_one(chapter);
    claim_steps_towards_one(chapter);
    chart_stagnation(chapter);
    claim_stagnation(chapter);
}

/// 8.6  How many patches does it take?
void convergence(course::Chapter& chapter) {
    chapter.section("8.6 How fine a mesh");
    chart_convergence(chapter);
}

/// 8.7  What does the Cornell box look like, from anywhere?
/// @param own  scene, of the person who asks, beside it
void cornell_box_views(course::Chapter& chapter, const std::optional<OwnScene>& own) {
    chapter.section("8.7 The Cornell box");
    if (own) render_own_scene(chapter, *own);
    const int    threads = chapter.options().threads;
    const double coarse  = 90;  // [mm], whatever the quality: its numbers are in the text
    const auto   box     = solve_cornell_box(coarse, threads);
    const auto   aligned =
        solve_patches(cut(polygons_with_aligned_floor(), coarse), cornell_box().mesh, threads);
    show_matrix(chapter, box, aligned);
    render_bounces(chapter, box);
    if (chapter.options().quality == course::Quality::draft)
        render_views(chapter, box);
    else
        render_views(chapter, solve_cornell_box(coarse / 2, threads));
    show_leaks(chapter, box, aligned);
}

/// 8.8  Must every patch know every other?
void hierarchical(course::Chapter& chapter) {
    chapter.section("8.8 Hierarchical radiosity");
    auto links = chapter.diagram("links", "Which patches exchange light, and at which size");
    draw_link_levels(links);
    links.caption("What lies near each other is cut finely, and what is far away is left large.");

    const CornellMeshes               box;
    const int                         threads = chapter.options().threads;
    std::vector<HierarchicalSolution> solutions;
    for (const double bound : {0.04, 0.01, 0.0025}) solutions.push_back(box.solution(bound, threads));
    for (std::size_t i = 0; i < solutions.size(); ++i)
        chapter.render(fmt::format("mesh_{}", i + 1), "Leaves where they are needed",
                       fmt::format("The {} leaves of a solution.", solutions[i].trees.leaf_count()),
                       picture_of_mesh(solutions[i], chapter.options().size, threads));
    const auto finer      = box.solution(0.001, threads);
    const auto from_finer = box.gathered(finer, threads);
    claim_refinement(chapter, box, solutions, from_finer);
    claim_walls(chapter, box, solutions.back(), finer);
    chart_scaling(chapter, box, from_finer);
}

/// 8.9  What can't it do?
void failures(course::Chapter& chapter) {
    chapter.section("8.9 Where it fails");
    chart_above_one(chapter);
    chart_closed_set(chapter);
    show_lost_light(chapter);
    chart_slivers(chapter);
    chart_sees_itself(chapter);
    show_mirror_block(chapter);
    chart_fence(chapter);
}

}  // namespace
}  // namespace sr

int main(int argc, char** argv) {
    using namespace sr;
    const course::Defaults defaults{.takes_seed = false, .scene_section = "8.7"};
    return course::run(argc, argv, "08_radiosity", "Radiosity", defaults, [](course::Chapter& chapter) {
        const auto own = own_scene(chapter);  // first: what is wrong with it is told before any work is done
        radiosity_equation(chapter);
        form_factors(chapter);
        computing_form_factors(chapter);
        linear_system(chapter);
        solvers(chapter);
        convergence(chapter);
        cornell_box_views(chapter, own);
        hierarchical(chapter);
        failures(chapter);
    });
}
