/// @file program.cpp

#include "course/program.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#ifndef _WIN32
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>

extern char** environ;
#endif

namespace sr::course {
namespace {

[[noreturn]] void fail(const std::string& program, int reason) {
    throw std::runtime_error(fmt::format("cannot run {}: {}", program, std::strerror(reason)));
}

/// Cuts what arrives into lines; the last may lack its end.
class Lines {
public:
    explicit Lines(const EachLine& each_line) : each_line_(each_line) {}

    void add(std::string_view text) {
        for (const char c : text) {
            if (c == '\n') {
                each_line_(line_);
                line_.clear();
            } else {
                line_ += c;
            }
        }
    }
    void end() {
        if (!line_.empty()) each_line_(line_);
    }

private:
    const EachLine& each_line_;
    std::string     line_;
};

#ifdef _WIN32

std::string quoted(const std::vector<std::string>& words) {
    std::string command;
    for (const std::string& word : words) command += fmt::format("\"{}\" ", word);
    return command;
}

int run_and_wait(const std::vector<std::string>& words, const EachLine& each_line) {
    // cmd takes the outermost pair of quotes away
    const std::string command = fmt::format("\"{} 2>&1\"", quoted(words));
    std::FILE* const  pipe    = each_line ? _popen(command.c_str(), "r") : nullptr;
    if (!pipe) return std::system(fmt::format("\"{}\"", quoted(words)).c_str());
    Lines lines(each_line);
    char  text[4096];
    while (std::fgets(text, sizeof text, pipe)) lines.add(text);
    lines.end();
    return _pclose(pipe);
}

#else

volatile std::sig_atomic_t interrupted = 0;
volatile std::sig_atomic_t child       = 0;

void outlive(int signal) {
    if (signal == SIGINT) interrupted = 1;
    if (signal == SIGTERM && child > 0) kill(child, SIGTERM);
}

/// For its lifetime an interrupt is the running program's to handle. A handler, unlike "ignore", does not
/// pass on to that program.
class Outlive {
public:
    Outlive() {
        interrupted             = 0;
        struct sigaction action = {};
        action.sa_handler       = outlive;
        action.sa_flags         = SA_RESTART;
        sigaction(SIGINT, &action, &interrupt_);
        sigaction(SIGTERM, &action, &terminate_);
    }
    ~Outlive() {
        sigaction(SIGINT, &interrupt_, nullptr);
        sigaction(SIGTERM, &terminate_, nullptr);
    }
    Outlive(const Outlive&)            = delete;
    Outlive& operator=(const Outlive&) = delete;

private:
    struct sigaction interrupt_ = {};
    struct sigaction terminate_ = {};
};

/// A pipe's two ends, or neither.
struct Pipe {
    int read_end  = -1;
    int write_end = -1;
};

/// Starts a program whose stdout and stderr go into `output`, or to ours where that is no pipe.
pid_t start(const std::vector<std::string>& words, const Pipe& output = {}) {
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    if (output.write_end >= 0) {
        posix_spawn_file_actions_adddup2(&actions, output.write_end, STDOUT_FILENO);
        posix_spawn_file_actions_adddup2(&actions, output.write_end, STDERR_FILENO);
        posix_spawn_file_actions_addclose(&actions, output.write_end);
        posix_spawn_file_actions_addclose(&actions, output.read_end);
    }
    pid_t     pid    = 0;
    const int reason = posix_spawnp(&pid, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (reason != 0) fail(words[0], reason);
    return pid;
}

/// Waits for it to end.
int exit_code(pid_t pid) {
    int status = 0;
    while (waitpid(pid, &status, 0) < 0 && errno == EINTR) {
    }
    child = 0;
    if (interrupted) return 128 + SIGINT;
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

int run_and_wait(const std::vector<std::string>& words, const EachLine& each_line) {
    const Outlive outlive_it;
    if (!each_line) {
        child = start(words);
        return exit_code(child);
    }

    std::array<int, 2> ends = {};
    if (pipe(ends.data()) != 0) fail(words[0], errno);
    child = start(words, {.read_end = ends[0], .write_end = ends[1]});
    close(ends[1]);
    Lines                  lines(each_line);
    std::array<char, 4096> text;
    ssize_t                count = 0;
    while ((count = read(ends[0], text.data(), text.size())) > 0)
        lines.add({text.data(), std::size_t(count)});
    lines.end();
    close(ends[0]);
    return exit_code(child);
}

#endif

}  // namespace

int run_program(const std::vector<std::string>& words, const EachLine& each_line) {
    std::fflush(nullptr);  // what we said before comes before what the program says
    return run_and_wait(words, each_line);
}

}  // namespace sr::course
