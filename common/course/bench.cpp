/// @file bench.cpp

#include "course/bench.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>

#include "course/options.hpp"
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
    const auto measure = [&](const Arguments& arguments) {
        const std::optional<std::string> csv = arguments.value("--csv");
        if (csv) check_writable(*csv);
        const Rows result = rows();
        print(result);
        if (csv) write_csv(*csv, result);
        return 0;
    };
    return run_command(argc, argv,
                       {.name    = std::filesystem::path(argv[0]).stem().string(),
                        .help    = std::string(about),
                        .options = {{"--csv", "FILE", "write the table to FILE as well"}},
                        .run     = measure});
}

}  // namespace sr::course
