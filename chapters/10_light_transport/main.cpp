/// @file main.cpp
/// Chapter 10, Light transport: all light of a scene by random paths, and how to find it sooner.

#include <optional>

#include "asked_and_met.hpp"
#include "between_mirrors.hpp"
#include "box_by_radiosity.hpp"
#include "box_pictures.hpp"
#include "box_shadow.hpp"
#include "box_walls.hpp"
#include "counted_twice.hpp"
#include "course/chapter.hpp"
#include "course/interruptible.hpp"
#include "cut_paths.hpp"
#include "error_race.hpp"
#include "error_race_claims.hpp"
#include "filter_figures.hpp"
#include "known_charts.hpp"
#include "light_sampling_claims.hpp"
#include "mistakes_table.hpp"
#include "own_error_charts.hpp"
#include "partial_sums_chart.hpp"
#include "parts_figures.hpp"
#include "plate_figures.hpp"
#include "random_path_figures.hpp"
#include "render_to_error.hpp"
#include "roulette_charts.hpp"
#include "scores_chart.hpp"
#include "squeezed_paths.hpp"
#include "two_ways_to_squares.hpp"
#include "vanishing_room.hpp"

namespace sr {
namespace {

/// 10.1  What does a pixel see, after all bounces?
void random_paths(course::Chapter& chapter) {
    chapter.section("10.1 Light by random paths");
    render_random_paths(chapter);
    chart_random_paths(chapter);
    claim_black_pixels(chapter);
    claim_missing_light(chapter);
}

/// 10.2  Why wait until a path meets the lamp?
void lamps(course::Chapter& chapter) {
    chapter.section("10.2 Ask the lamp");
    claim_counted_twice(chapter);
    render_asked_and_met(chapter);
    claim_asked_and_met(chapter);
    chart_near_lamp(chapter);
    claim_near_lamp(chapter);
    claim_ball_lamp(chapter);
    claim_two_balls(chapter);
}

/// 10.3  Which of two ways is right? Both are.
void both(course::Chapter& chapter) {
    chapter.section("10.3 Two ways to find light, and their weights");
    claim_two_ways_to_squares(chapter);
    render_plates(chapter);
    const PlateErrors errors(chapter.options().threads);
    draw_plate_errors(chapter, errors);
    claim_plate_errors(chapter, errors);
    render_light_split(chapter);
    claim_light_split(chapter, errors);
}

/// 10.4  When may a path end?
void roulette(course::Chapter& chapter) {
    chapter.section("10.4 Russian roulette");
    claim_roulette(chapter);
    claim_traced_roulette(chapter);
    chart_roulette_variance(chapter);
    chart_roulette_cost(chapter);
    claim_best_survival(chapter);
    chart_infinite_variance(chapter);
    chart_path_ends(chapter);
    claim_cut_paths(chapter);
    claim_squeezed(chapter);
}

/// 10.5  Which paths are there, and who finds which?
void ways(course::Chapter& chapter) {
    chapter.section("10.5 Ways of light");
    render_parts(chapter);
    claim_sum_of_parts(chapter);
    claim_parts(chapter);
    chart_partial_sums(chapter);
    claim_partial_sums(chapter);
}

/// 10.6  Is it right?
void exactness(course::Chapter& chapter) {
    chapter.section("10.6 Pictures that are known");
    claim_known_scenes(chapter);
    render_vanishing_room(chapter);
    chart_scores(chapter);
    chart_shining_balls(chapter);
    chart_plates_between_mirrors(chapter);
    chart_profiles(chapter);
    show_mistakes(chapter);
}

/// 10.7  Do radiosity and paths agree?
void radiosity(course::Chapter& chapter) {
    chapter.section("10.7 The box, by two methods");
    const BoxByRadiosity box;
    const int            threads = chapter.options().threads;
    const auto           coarse = box.solution(0.01, threads), fine = box.solution(0.0025, threads);
    render_box_by_both(chapter, box, fine);
    compare_walls(chapter, box, coarse, fine);
    chart_box_shadow(chapter, box, fine);
}

/// 10.8  Is a pixel a square?
void filters(course::Chapter& chapter) {
    chapter.section("10.8 What a pixel sees");
    render_zone_plates(chapter);
    chart_filter_responses(chapter);
    claim_filter_responses(chapter);
}

/// 10.9  What does an error cost?
void efficiency(course::Chapter& chapter, const ErrorRace& race) {
    chapter.section("10.9 Error against time");
    race_strategies(chapter, race);
}

/// 10.10  When is a picture done?
void own_error(course::Chapter& chapter, const std::optional<SceneView>& own, const ErrorRace& race) {
    {
        const course::Interruptible interrupt;  // what is rendered here may take long
        chapter.section("10.10 A picture that knows its error");
        render_to_error(chapter, own, interrupt);
    }
    claim_stated_errors(chapter, race);
    claim_requested_errors(chapter, race);
}

}  // namespace
}  // namespace sr

int main(int argc, char** argv) {
    using namespace sr;
    const course::Defaults defaults{.size          = {.draft = 64, .lecture = 256, .print = 512},
                                    .takes_seed    = false,
                                    .scene_section = "10.10",
                                    .error_section = "10.10"};
    return course::run(
        argc, argv, "10_light_transport", "Light transport", defaults, [](course::Chapter& chapter) {
            const auto own = scene_with_lamps(chapter);  // first: what is wrong with it is told
            random_paths(chapter);
            lamps(chapter);
            both(chapter);
            roulette(chapter);
            ways(chapter);
            exactness(chapter);
            radiosity(chapter);
            filters(chapter);
            const ErrorRace race(1024, {.threads = chapter.options().threads});
            efficiency(chapter, race);
            own_error(chapter, own, race);
        });
}
