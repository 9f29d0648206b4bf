#pragma once
/// @file child.hpp
/// Runs a function in a process of its own, for what would end or wound this one.

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <functional>
#include <string>

#include "course/program.hpp"

namespace sr::test {

using course::Ended;

inline auto error_lines(const Ended& ended) {
    return std::count(ended.err.begin(), ended.err.end(), '\n');
}

inline std::string read_all(std::FILE* file) {
    std::string text;
    std::rewind(file);
    for (int c; (c = std::fgetc(file)) != EOF;) text += char(c);
    std::fclose(file);
    return text;
}

/// Whether the child has not ended yet.
inline bool runs(pid_t child) {
    siginfo_t ended = {};
    ::waitid(P_PID, id_t(child), &ended, WEXITED | WNOHANG | WNOWAIT);
    return ended.si_pid == 0;
}

/// @param meanwhile   called in this process while the child runs, with the child's id
inline Ended in_child(const std::function<int()>& work, const std::function<void(pid_t)>& meanwhile = {}) {
    std::FILE* out = std::tmpfile();
    std::FILE* err = std::tmpfile();
    std::fflush(nullptr);
    const pid_t child = ::fork();
    if (child == 0) {
        ::dup2(::fileno(out), 1);
        ::dup2(::fileno(err), 2);
        int code = 99;
        try {
            code = work();
        } catch (const std::exception& error) {
            std::fputs(error.what(), stderr);
        }
        std::fflush(nullptr);
        ::_exit(code);
    }
    if (meanwhile) meanwhile(child);
    int status = 0;
    while (::waitpid(child, &status, 0) == -1 && errno == EINTR) {
    }
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return {code, read_all(out), read_all(err)};
}

}  // namespace sr::test
