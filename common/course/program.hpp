#pragma once
/// @file program.hpp
/// Runs another program: a compiler, a chapter, gnuplot. No shell lies in between, so that no word needs
/// quotes.

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sr::course {

/// Gets a program's output, stdout and stderr, line by line.
using EachLine = std::function<void(std::string_view)>;

/// Runs a program and waits until it ends. Ctrl-C reaches that program too: we outlive it, so that it can
/// tidy up, and SIGTERM is passed on to it.
/// @param words      the program, looked up on the PATH where it names no folder, and its arguments
/// @param each_line  gets the output; without it the program writes where we write
/// @return its exit code; 128 + n where signal n ended it; 130 after Ctrl-C, whatever the program made of it
/// @throws std::runtime_error where there is no such program
[[nodiscard]] int run_program(const std::vector<std::string>& words, const EachLine& each_line = {});

/// What a program left behind when it ended: its exit code, 128 + n where signal n ended it, and what it wrote.
struct Ended {
    int         code = -1;
    std::string out;
    std::string err;
};

/// Runs a program on a given input and keeps what it writes. Ctrl-C is ours to handle.
/// @return nothing where there is no such program
[[nodiscard]] std::optional<Ended> filter_through(const std::vector<std::string>& words,
                                                  std::string_view                input);

}  // namespace sr::course
