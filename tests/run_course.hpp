#pragma once
/// @file run_course.hpp
/// Runs the built `course` as a person does, from a folder of its own, and keeps what it says.

#include <unistd.h>

#include <filesystem>
#include <string>

#include "child.hpp"
#include "scratch_folder.hpp"

namespace sr::test {

namespace fs = std::filesystem;

const inline fs::path source_folder = STERADIAN_SOURCE_DIR;
const inline fs::path build_folder  = STERADIAN_BINARY_DIR;

/// Runs a line of shell in `folder`.
inline Ended run_shell(const fs::path& folder, const std::string& line) {
    const std::string all = "cd '" + folder.string() + "' && { " + line + "; } </dev/null";
    return in_child([&] { return ::execl("/bin/sh", "sh", "-c", all.c_str(), nullptr); });
}

/// Runs `course` with these arguments in `folder`.
inline Ended run_course(const fs::path& folder, const std::string& arguments) {
    return run_shell(folder, "'" + (build_folder / "bin" / "course").string() + "' " + arguments);
}

inline Ended run_course(const std::string& arguments) {
    const ScratchFolder scratch{"course"};
    return run_course(scratch.path, arguments);
}

}  // namespace sr::test
