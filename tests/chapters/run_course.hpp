#pragma once
/// @file run_course.hpp
/// Runs the built `course` as a person does, from a folder of its own, and keeps what it says.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#ifndef _WIN32
#include <sys/wait.h>
#include <unistd.h>
#endif

namespace sr::test {

namespace fs = std::filesystem;

const inline fs::path source_folder = STERADIAN_SOURCE_DIR;
const inline fs::path build_folder  = STERADIAN_BINARY_DIR;

inline std::string read_text(const fs::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// An empty folder that goes when its owner does.
class Scratch {
public:
    Scratch() { fs::create_directories(path); }
    ~Scratch() {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
    Scratch(const Scratch&)            = delete;
    Scratch& operator=(const Scratch&) = delete;

    const fs::path path = fs::temp_directory_path() / ("steradian-" + std::to_string(getpid()));
};

/// What a program said and how it ended.
struct Ended {
    int         code = -1;
    std::string out;
    std::string err;

    [[nodiscard]] auto error_lines() const { return std::count(err.begin(), err.end(), '\n'); }
};

/// Runs a line of shell in `folder`.
inline Ended run_shell(const fs::path& folder, const std::string& line) {
    const fs::path    out    = folder / ".out";
    const fs::path    err    = folder / ".err";
    const std::string all    = "cd '" + folder.string() + "' && { " + line + "; } >.out 2>.err </dev/null";
    const int         status = std::system(all.c_str());
    Ended             ended{WEXITSTATUS(status), read_text(out), read_text(err)};
    fs::remove(out);
    fs::remove(err);
    return ended;
}

/// Runs `course` with these arguments in `folder`.
inline Ended run_course(const fs::path& folder, const std::string& arguments) {
    return run_shell(folder, "'" + (build_folder / "bin" / "course").string() + "' " + arguments);
}

inline Ended run_course(const std::string& arguments) {
    const Scratch scratch;
    return run_course(scratch.path, arguments);
}

}  // namespace sr::test
