/// @file rows.cpp

#include "radiosity/rows.hpp"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>

namespace sr {

void for_each_row(std::size_t n, const RowLoop& loop, const std::function<void(std::size_t i)>& row) {
    std::atomic<int> done     = 0;
    const auto       with_row = [&](std::size_t i) {
        row(i);
        const int count = ++done;
        if (loop.on_row) loop.on_row(count, int(n));
    };
    if (loop.threads == 1) {  // as often as small systems are solved, an arena costs more than the rows
        for (std::size_t i = 0; i < n; ++i) with_row(i);
        return;
    }
    const int                 threads = loop.threads > 0 ? loop.threads : tbb::info::default_concurrency();
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, std::size_t(threads));
    tbb::task_arena           arena(threads);
    arena.execute([&] { tbb::parallel_for(std::size_t{0}, n, with_row); });
}

}  // namespace sr
