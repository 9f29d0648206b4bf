#pragma once
/// @file quality.hpp
/// Section 7.5: how far a picture is from the one that all bounces make, and what that costs.

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "course/chapter.hpp"
#include "picture.hpp"
#include "statistics/running.hpp"

namespace sr {

/// A way to render: what it is called, and how much effort it makes.
struct Recipe {
    std::string      name;
    double           effort = 0;
    RecursionOptions recursion;
    int trees = 1;  ///< for each of a pixel's rays; more than one only makes sense if they are random
};

/// A relative RMSE, and its standard error as far as chance has a part in it.
struct ImageError {
    double value = 0;
    double error = 0;
};

/// The picture by which recipes are judged: all rays pass through the same points of it, so that what is compared is
/// recursion alone.
class Judge {
public:
    Judge(SceneView view, int threads) : view_{std::move(view)}, threads_{threads} {
        reference_ = shown({"reference", 0, {.depth = 64}}, threads_);
        const Surfaces<float> surfaces(view_.scene);
        const auto            camera = convert<float>(view_.camera);
        sees_lamp_                   = Image<char>(camera.width, camera.height);
        for (int y = 0; y < camera.height; ++y) {
            for (int x = 0; x < camera.width; ++x) {
                for (const auto& [dx, dy] :
                     {std::pair{0.25F, 0.25F}, {0.75F, 0.25F}, {0.25F, 0.75F}, {0.75F, 0.75F}}) {
                    const auto hit = surfaces.nearest(camera.ray({float(x) + dx, float(y) + dy}));
                    if (hit && !(view_.scene.materials[hit->material].emission == Spectrum{}))
                        sees_lamp_(x, y) = 1;
                }
            }
        }
    }

    [[nodiscard]] Image<Spectrum> shown(const Recipe& recipe, int threads) const {
        const RecursiveTracer tracer(view_.scene, recipe.recursion);
        return render(convert<float>(view_.camera), {.samples = 4, .seed = 1}, {.threads = threads},
                      [&](const Ray<float>& ray, Rng& rng) {
                          Spectrum sum;
                          RayCount count;
                          for (int i = 0; i < recipe.trees; ++i) sum = sum + tracer.radiance(ray, rng, count);
                          return 1 / float(recipe.trees) * sum;
                      });
    }

    /// sqrt(mean (I - R)^2) / mean R over the pixels that don't see the lamp, and all channels.
    [[nodiscard]] ImageError error(const Recipe& recipe) const {
        const auto image = shown(recipe, threads_);
        Running    squares, light;
        for (std::size_t i = 0; i < image.pixels().size(); ++i) {
            const Spectrum I = image.pixels()[i], R = reference_.pixels()[i];
            if (sees_lamp_.pixels()[i]) continue;
            squares.add((square(I.r - R.r) + square(I.g - R.g) + square(I.b - R.b)) / 3.0);
            light.add(double(mean(R)));
        }
        const double rmse   = std::sqrt(squares.mean());
        const bool   chance = recipe.recursion.branching == Branching::random;
        return {rmse / light.mean(), chance ? squares.standard_error() / (2 * rmse) / light.mean() : 0};
    }

private:
    static double square(float x) { return double(x) * double(x); }

    SceneView       view_;
    int             threads_;
    Image<Spectrum> reference_{1, 1};
    Image<char>     sees_lamp_{1, 1};  ///< of the pixels whose own rays end there
};

}  // namespace sr
