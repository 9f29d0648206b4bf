#pragma once
/// @file requested_error.hpp
/// Section 10.10: pictures that stop by an error, in three ways.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "error_race.hpp"
#include "math/square.hpp"
#include "stated_error.hpp"
#include "statistics/running.hpp"
#include "transport/to_error.hpp"

namespace sr {

enum class Stopping {
    all_alike,   ///< whole passes until the picture's error is small enough
    by_a_pilot,  ///< traced_to_error
    each_alone,  ///< each pixel, by its own standard error
};

/// What pictures that stop at an error came to.
struct RequestedErrors {
    Running squared_errors = {};  ///< over that asked for, squared
    Running light          = {};  ///< the mean radiance over the true one
    Running samples        = {};  ///< of a pixel, the pilot's too
};

/// A picture of the box whose samples are shared out in one of these ways.
class RequestedError {
public:
    RequestedError(const ErrorRace& race, double asked, const TileLoop& loop)
        : race_{race},
          asked_{asked},
          loop_{loop},
          camera_{convert<float>(race.camera())},
          tracer_{race.scene()} {}

    [[nodiscard]] RequestedErrors run(Stopping stopping, int pictures) const {
        RequestedErrors all;
        const auto      truth = race_.reference().mean();
        for (int i = 0; i < pictures; ++i) {
            const PassOptions pass{.seed = std::uint64_t(1300 + i), .samples = samples_of_pass};
            const auto        image = rendered(stopping, pass);
            const auto        film  = image.mean();
            double            count = double(image.samples()) / double(film.pixels().size());
            if (stopping == Stopping::by_a_pilot) count += ErrorGoal{}.pilot * samples_of_pass;
            all.squared_errors.add(squared_error(race_, film) / square(asked_));
            all.light.add(radiance_of(film, race_.mask()) / radiance_of(truth, race_.mask()));
            all.samples.add(count);
        }
        return all;
    }

private:
    static constexpr std::uint32_t samples_of_pass = 4;

    [[nodiscard]] SampledImage rendered(Stopping stopping, const PassOptions& pass) const {
        const auto radiance = [&](const Ray<float>& ray, SobolPoint& point) {
            PathCount count;
            return tracer_.radiance(ray, point, count);
        };
        const auto& mask = race_.mask();
        if (stopping == Stopping::by_a_pilot)
            return traced_to_error<SobolPoint>(camera_, mask, {.error = asked_}, pass, loop_, radiance,
                                               [](const SampledImage&) { return true; });
        SampledImage image(camera_, pass);
        for (int i = 0; i < 2; ++i) image.add_pass<SobolPoint>(loop_, radiance);
        const double enough =
            asked_ * radiance_of(race_.reference().mean(), mask);  // as an alone pixel sees it
        while (true) {
            const auto errors = image.standard_errors();
            const auto wanted = [&](int x, int y) {
                return stopping == Stopping::all_alike || (mask(x, y) != 0 && double(errors(x, y)) > enough);
            };
            const bool done = stopping == Stopping::all_alike ? image.relative_error(mask) <= asked_
                                                              : !any_pixel(mask, wanted);
            if (done) return image;
            image.add_pass<SobolPoint>(loop_, radiance, wanted);
        }
    }

    const ErrorRace& race_;
    double           asked_;
    TileLoop         loop_;
    Camera<float>    camera_;
    PathTracer       tracer_;
};

}  // namespace sr
