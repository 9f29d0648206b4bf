#pragma once
/// @file bench.hpp
/// What a benchmark's program is written with: it makes rows, and shows or saves them.

#include <functional>
#include <string_view>

#include "course/csv.hpp"

namespace sr::course {

/// Runs a benchmark: `--help`, and `--csv FILE` to write the rows to a file as well.
/// @return the exit code: 0, or 2 after one line on stderr
[[nodiscard]] int run_benchmark(int argc, const char* const* argv, std::string_view about,
                                const std::function<Rows()>& rows);

}  // namespace sr::course
