/// @file bench.cpp

#include "course/bench.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "course/table.hpp"

namespace sr::course {

namespace {

/// Fails before an hour's work and not after it, if the file can't be written.
void check_writable(const std::filesystem::path& file) {
    const auto folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
    if (!std::filesystem::is_directory(folder)) {
        throw std::runtime_error(
            fmt::format("--csv {}: there is no folder {}", file.string(), folder.string()));
    }
    if (std::filesystem::is_directory(file)) {
        throw std::runtime_error(fmt::format("--csv {}: is a folder; name a file", file.string()));
    }
}

}  // namespace

int run_benchmark(int argc, const char* const* argv, std::string_view about,
                  const std::function<Rows()>& rows) {
    try {
        const std::vector<std::string>       words(argv + 1, argv + argc);
        std::optional<std::filesystem::path> csv;
        for (std::size_t i = 0; i < words.size(); ++i) {
            if (words[i] == "--help" || words[i] == "-h") {
                fmt::print("{}\n\n  --csv FILE  write the rows to FILE as well\n", about);
                return 0;
            }
            if (words[i] != "--csv" || i + 1 == words.size()) {
                throw std::invalid_argument(fmt::format("{}: expected nothing or --csv FILE", words[i]));
            }
            csv = words[++i];
            check_writable(*csv);
        }
        const Rows result = rows();
        print(result);
        if (csv) write_csv(*csv, result);
        return 0;
    } catch (const std::exception& error) {
        fmt::print(stderr, "bench: error: {}\n", error.what());
        return 2;
    }
}

}  // namespace sr::course
