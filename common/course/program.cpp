/// @file program.cpp

#include "course/program.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#ifdef _WIN32
#include <process.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#else
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <exception>
#include <memory>

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
    try {
        while (std::fgets(text, sizeof text, pipe)) lines.add(text);
        lines.end();
    } catch (...) {
        _pclose(pipe);
        throw;
    }
    return _pclose(pipe);
}

/// By way of three files in a temporary folder of this process.
std::optional<Ended> filter_and_wait(const std::vector<std::string>& words, std::string_view input) {
    if (std::system(fmt::format("where {} >NUL 2>&1", words[0]).c_str()) != 0) return std::nullopt;
    const auto folder = std::filesystem::temp_directory_path() / fmt::format("steradian_{}", _getpid());
    std::filesystem::create_directories(folder);
    const auto file = [&](const char* name) { return (folder / name).string(); };
    const auto read = [&](const char* name) {
        std::ifstream stream{file(name), std::ios::binary};
        return std::string{std::istreambuf_iterator<char>{stream}, {}};
    };
    std::ofstream{file("input"), std::ios::binary} << input;
    const int exit_code = std::system(fmt::format("\"{} <\"{}\" >\"{}\" 2>\"{}\"\"", quoted(words),
                                                  file("input"), file("output"), file("errors"))
                                          .c_str());
    Ended     ended{exit_code, read("output"), read("errors")};
    std::filesystem::remove_all(folder);
    return ended;
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

/// What a program reads from and writes to.
struct Streams {
    int in  = STDIN_FILENO;
    int out = STDOUT_FILENO;
    int err = STDERR_FILENO;
};

/// @return the program's process; nothing where there is no such program
std::optional<pid_t> start(const std::vector<std::string>& words, const Streams& streams = {}) {
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, streams.in, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, streams.out, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, streams.err, STDERR_FILENO);
    pid_t     pid    = 0;
    const int reason = posix_spawnp(&pid, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (reason == ENOENT) return std::nullopt;
    if (reason != 0) fail(words[0], reason);
    child = pid;
    return pid;
}

/// Waits for it to end.
int exit_code(pid_t pid) {
    int status = 0;
    while (waitpid(pid, &status, 0) < 0 && errno == EINTR) {
    }
    child = 0;
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

/// A pipe whose ends no program inherits.
class Pipe {
public:
    Pipe() {
        if (pipe(ends_.data()) != 0) fail("a program with a pipe", errno);
        for (const int end : ends_) fcntl(end, F_SETFD, FD_CLOEXEC);
    }
    ~Pipe() {
        close_from();
        close_to();
    }
    Pipe(const Pipe&)            = delete;
    Pipe& operator=(const Pipe&) = delete;

    [[nodiscard]] int from() const { return ends_[0]; }
    [[nodiscard]] int to() const { return ends_[1]; }

    void close_from() { close_end(ends_[0]); }
    void close_to() { close_end(ends_[1]); }

private:
    static void close_end(int& end) {
        if (end >= 0) close(end);
        end = -1;
    }

    std::array<int, 2> ends_ = {-1, -1};
};

void read_lines(int from, const EachLine& each_line) {
    Lines                  lines(each_line);
    std::array<char, 4096> text;
    ssize_t                count = 0;
    while ((count = read(from, text.data(), text.size())) > 0) lines.add({text.data(), std::size_t(count)});
    lines.end();
}

/// Waits for the program also where `each_line` throws, and only then passes that on.
int read_and_wait(const std::vector<std::string>& words, const EachLine& each_line) {
    Pipe       pipe;
    const auto pid = start(words, {.out = pipe.to(), .err = pipe.to()});
    if (!pid) fail(words[0], ENOENT);
    pipe.close_to();
    std::exception_ptr thrown;
    try {
        read_lines(pipe.from(), each_line);
    } catch (...) {
        thrown = std::current_exception();
    }
    pipe.close_from();  // so that a program which still writes ends
    const int code = exit_code(*pid);
    if (thrown) std::rethrow_exception(thrown);
    return code;
}

int run_and_wait(const std::vector<std::string>& words, const EachLine& each_line) {
    const Outlive outlive_it;
    int           code = 0;
    if (each_line) {
        code = read_and_wait(words, each_line);
    } else {
        const auto pid = start(words);
        if (!pid) fail(words[0], ENOENT);
        code = exit_code(*pid);
    }
    return interrupted ? 128 + SIGINT : code;
}

/// A file without a name: it is gone with the program that has it open, however that ends.
class NamelessFile {
public:
    NamelessFile() : file_{std::tmpfile(), std::fclose} {
        if (!file_)
            throw std::runtime_error(fmt::format("cannot make a temporary file: {}", std::strerror(errno)));
    }

    [[nodiscard]] int descriptor() const { return ::fileno(file_.get()); }

    void write(std::string_view text) {
        if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size() ||
            std::fflush(file_.get()) != 0)
            throw std::runtime_error(fmt::format("cannot write a temporary file: {}", std::strerror(errno)));
        std::rewind(file_.get());
    }

    [[nodiscard]] std::string read() {
        std::string            text;
        std::array<char, 4096> block;
        std::rewind(file_.get());
        while (const std::size_t n = std::fread(block.data(), 1, block.size(), file_.get()))
            text.append(block.data(), n);
        return text;
    }

private:
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

/// Files and not pipes, which would fill up: the program may write before it has read all.
std::optional<Ended> filter_and_wait(const std::vector<std::string>& words, std::string_view input) {
    NamelessFile in, out, errors;
    in.write(input);
    const auto pid = start(words, {in.descriptor(), out.descriptor(), errors.descriptor()});
    if (!pid) return std::nullopt;
    const int code = exit_code(*pid);
    return Ended{code, out.read(), errors.read()};
}

#endif

}  // namespace

int run_program(const std::vector<std::string>& words, const EachLine& each_line) {
    std::fflush(nullptr);  // what we said before comes before what the program says
    return run_and_wait(words, each_line);
}

std::optional<Ended> filter_through(const std::vector<std::string>& words, std::string_view input) {
    return filter_and_wait(words, input);
}

}  // namespace sr::course
