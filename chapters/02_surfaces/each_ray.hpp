#pragma once
/// @file each_ray.hpp

#include <type_traits>
#include <vector>

#include "transport/tiles.hpp"

namespace sr {

/// What `of(i)` says of ray i, for so many rays, in their order: the same for any number of threads.
template <class Of>
[[nodiscard]] auto each_ray(int count, int threads, const Of& of) {
    constexpr int                              width = 1024;
    std::vector<std::invoke_result_t<Of, int>> results(static_cast<std::size_t>(count));
    for_each_pixel(width, (count + width - 1) / width, {.threads = threads}, [&](int x, int y) {
        const int i = y * width + x;
        if (i < count) results[std::size_t(i)] = of(i);
    });
    return results;
}

}  // namespace sr
