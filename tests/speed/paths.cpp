/// @file paths.cpp
/// Paths per second, and what an error costs: the Cornell box, 512 x 512, by each way to find light.
///
/// - `scene`, `method`: as in section 10.9's chart of errors against time; points are scrambled Sobol' ones, or random
///   where that is said.
/// - `threads`: one, and as many as there are processors. The picture is the same to the bit.
/// - `samples`: of each pixel, the power of 2 that a relative RMSE of 10 % should take, or 16 where 128 are not enough.
/// - `mpaths_per_s`: millions of camera paths in a second.
/// - `seconds`: for the picture.
/// - `rmse`: relative, over pixels that don't see the lamp, against a picture with 1024 samples of its own, whose
///   standard error is in the last row.
/// - `mse_seconds`: rmse^2 times seconds. Where samples are independent it does not depend on their number, and a
///   hundred times it are the seconds that an error of 10 % takes.
///
/// Expect twice the threads to bring about twice the paths, and the lamp to be worth a factor of hundreds in
/// mse_seconds.
///
/// It takes about a quarter of an hour.

#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <thread>

#include "../../chapters/10_light_transport/error_race.hpp"
#include "course/bench.hpp"
#include "course/progress.hpp"
#include "course/timing.hpp"
#include "math/square.hpp"
#include "scene/cornell_box.hpp"
#include "transport/image_error.hpp"
#include "transport/traced.hpp"

namespace sr {
namespace {

constexpr int           side        = 512;
constexpr double        wanted      = 0.1;  // relative RMSE
constexpr std::uint32_t few_samples = 16, most_samples = 128;

/// A picture of the box.
SampledImage picture(const Racer& racer, const PassOptions& pass, const TileLoop& loop, int passes = 1) {
    static const Scene box    = cornell_box();
    const auto         camera = cornell_box_camera(side);
    return racer.by_sobol ? traced<SobolPoint>(box, camera, racer.paths, pass, loop, passes)
                          : traced<RandomPoint>(box, camera, racer.paths, pass, loop, passes);
}

/// What others are held against, and which of its pixels count.
struct Reference {
    SampledImage image;
    PixelMask    mask;

    [[nodiscard]] double rmse_of(const SampledImage& other) const {
        return relative_rmse(other.mean(), image.mean(), mask);
    }
};

Reference reference() {
    constexpr int    passes = 16;
    course::Progress progress("rendering the picture that others are held against", passes * 1000);
    const TileLoop   loop{.threads = 0, .on_tile = [&](int done, int of) {
                            progress.tick(course::steps_of_part(1000, done, of));
                        }};
    return {picture({"reference", {}}, {.seed = 1090, .samples = 1024 / passes}, loop, passes),
            without_emitters(cornell_box(), cornell_box_camera(side))};
}

/// The least power of 2 that is enough, by the law n^-1/2 from a picture with few; those few if it is out of reach.
std::uint32_t samples_for(const Racer& racer, const Reference& reference) {
    const double few_rmse = reference.rmse_of(picture(racer, {.samples = few_samples}, {.threads = 0}));
    const double enough   = few_samples * square(few_rmse / wanted);
    return enough <= most_samples ? std::bit_ceil(std::uint32_t(std::ceil(enough))) : few_samples;
}

void add(course::Rows& table, const Racer& racer, const Reference& reference) {
    const std::uint32_t samples = samples_for(racer, reference);
    for (const int threads : {1, int(std::thread::hardware_concurrency())}) {
        double       rmse    = 0;
        const double seconds = course::seconds_of(
            [&] { rmse = reference.rmse_of(picture(racer, {.samples = samples}, {threads})); });
        const double paths = double(side) * side * samples;
        table.add({"Cornell box", racer.name, threads, samples, paths / seconds * 1e-6, seconds, rmse,
                   square(rmse) * seconds});
    }
}

course::Rows rows() {
    course::Rows table{
        {"scene", "method", "threads", "samples", "mpaths_per_s", "seconds", "rmse", "mse_seconds"}};
    const Reference  best = reference();
    course::Progress progress("rendering the box", int(racers.size()));
    for (const auto& racer : racers) {
        add(table, racer, best);
        progress.tick();
    }
    table.add({"Cornell box", "reference", "", best.image.passes(0, 0) * 64, "", "",
               best.image.relative_error(best.mask), ""});
    return table;
}

}  // namespace
}  // namespace sr

int main(int argc, char** argv) {
    return sr::course::run_benchmark(argc, argv,
                                     "Paths per second and what an error costs, by each way to find light; "
                                     "`course bench paths --help` tells what "
                                     "the columns are.",
                                     [] { return sr::rows(); });
}
