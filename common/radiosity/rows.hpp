#pragma once
/// @file rows.hpp
/// The loop over patches, shared out to threads.

#include <cstddef>
#include <functional>

namespace sr {

/// How a loop over patches is carried out. Neither changes what is computed.
struct RowLoop {
    int                                   threads = 1;   ///< 0: one for each processor
    std::function<void(int done, int of)> on_row  = {};  ///< told as rows are finished, from any thread
};

/// Calls row(i) once for each i < n. Rows run at the same time: none may write where another reads or writes. Of the
/// exceptions thrown by `row` or `on_row`, one is passed on.
void for_each_row(std::size_t n, const RowLoop& loop, const std::function<void(std::size_t i)>& row);

}  // namespace sr
