#include "transport/tiles.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

#include "geometry/hierarchy.hpp"
#include "sampling/rng.hpp"
#include "scene/teapot.hpp"
#include "transport/primary.hpp"

using namespace sr;

TEST_CASE("every pixel is visited once, also where tiles do not fit") {
    for (const auto& [width, height] : {std::pair{1, 1}, {16, 16}, {17, 15}, {100, 37}}) {
        std::vector<std::atomic<int>> visits(std::size_t(width) * std::size_t(height));
        int                           tiles = 0;
        for_each_pixel(width, height, {.threads = 3}, [&, w = width](int x, int y) {
            ++visits[std::size_t(y) * std::size_t(w) + std::size_t(x)];
        });
        for_each_pixel(width, height,
                       {.threads = 1, .on_tile = [&](int done, int of) { tiles = done == of ? of : 0; }},
                       [](int, int) {});
        for (const auto& count : visits) CHECK(count == 1);
        CHECK(tiles == ((width + 15) / 16) * ((height + 15) / 16));
    }
}

TEST_CASE("an image is the same for 1, 2 and 7 threads") {
    const auto mesh = convert<float>(teapot(6));
    const auto camera =
        convert<float>(pinhole_camera<double>({4, -7, 4.5}, {-4, 7, -3}, {0, 0, 1}, 1.0, 0.8, 160, 120));
    const Hierarchy<float> hierarchy(mesh);
    const auto             noise = [](int threads) {
        Image<float> image(160, 120);
        for_each_pixel(160, 120, {.threads = threads}, [&](int x, int y) {
            Rng rng{1, std::uint32_t(x), std::uint32_t(y), 0};
            image(x, y) = rng.uniform();
        });
        return image;
    };
    const auto one = trace_primary(hierarchy, camera, {.threads = 1});
    for (const int threads : {2, 7}) {
        CHECK(trace_primary(hierarchy, camera, {.threads = threads}) == one);
        CHECK(noise(threads) == noise(1));
    }
}

TEST_CASE("what a pixel throws reaches the caller") {
    CHECK_THROWS_AS(for_each_pixel(64, 64, {.threads = 2},
                                   [](int x, int) {
                                       if (x == 63) throw std::runtime_error("bad pixel");
                                   }),
                    std::runtime_error);
}
