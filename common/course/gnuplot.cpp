/// @file gnuplot.cpp

#include "course/gnuplot.hpp"

#include <fmt/core.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <sstream>
#include <stdexcept>

#ifdef _WIN32
#include <filesystem>
#include <fstream>
#include <iterator>
#else
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
extern char** environ;
#endif

namespace sr::course {

namespace {

std::string gnuplot_program() {
    const char* chosen = std::getenv("STERADIAN_GNUPLOT");
    return chosen != nullptr ? chosen : "gnuplot";
}

/// gnuplot repeats the script and points at it; of all that, the lines which say what it was.
std::string said(const std::string& errors) {
    std::istringstream lines{errors};
    std::string        said;
    for (std::string line; std::getline(lines, line);) {
        line.erase(0, line.find_first_not_of(' '));
        if (!line.starts_with("line ") && !line.starts_with("warning: ")) continue;
        said += (said.empty() ? "" : "; ") + line;
    }
    return said;
}

/// What a program left behind when it ended.
struct Ended {
    int         exit_code = 0;
    std::string output;
    std::string errors;
};

#ifndef _WIN32

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

/// Runs `program -d -` with `script` on its standard input; nothing when there is no such program.
std::optional<Ended> run(std::string program, std::string_view script) {
    NamelessFile in;
    NamelessFile out;
    NamelessFile errors;
    in.write(script);

    posix_spawn_file_actions_t redirect;
    posix_spawn_file_actions_init(&redirect);
    posix_spawn_file_actions_adddup2(&redirect, in.descriptor(), 0);
    posix_spawn_file_actions_adddup2(&redirect, out.descriptor(), 1);
    posix_spawn_file_actions_adddup2(&redirect, errors.descriptor(), 2);
    std::string          default_settings = "-d";
    std::string          standard_input   = "-";
    std::array<char*, 4> words{program.data(), default_settings.data(), standard_input.data(), nullptr};
    pid_t                child = 0;
    const int error = ::posix_spawnp(&child, program.c_str(), &redirect, nullptr, words.data(), environ);
    posix_spawn_file_actions_destroy(&redirect);
    if (error == ENOENT) return std::nullopt;
    if (error != 0) throw std::runtime_error(fmt::format("cannot run {}: {}", program, std::strerror(error)));

    int status = 0;
    while (::waitpid(child, &status, 0) == -1 && errno == EINTR) {
    }
    const int exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return Ended{exit_code, out.read(), errors.read()};
}

#else

/// The same through the command interpreter and three files in the temporary folder.
std::optional<Ended> run(std::string program, std::string_view script) {
    const auto folder = std::filesystem::temp_directory_path() / "steradian";
    std::filesystem::create_directories(folder);
    const auto file = [&](const char* name) { return (folder / name).string(); };
    const auto read = [&](const char* name) {
        std::ifstream stream{file(name), std::ios::binary};
        return std::string{std::istreambuf_iterator<char>{stream}, {}};
    };
    if (std::system(fmt::format("where {} >NUL 2>&1", program).c_str()) != 0) return std::nullopt;
    std::ofstream{file("script")} << script;
    const int exit_code = std::system(
        fmt::format("{} -d \"{}\" >\"{}\" 2>\"{}\"", program, file("script"), file("picture"), file("errors"))
            .c_str());
    return Ended{exit_code, read("picture"), read("errors")};
}

#endif

}  // namespace

std::optional<std::string> run_gnuplot(std::string_view script) {
    const std::string program = gnuplot_program();
    if (program.empty()) return std::nullopt;
    const std::optional<Ended> ended = run(program, script);
    if (!ended) return std::nullopt;
    if (ended->exit_code != 0 || ended->output.empty())
        throw std::runtime_error(
            fmt::format("gnuplot: {} (exit code {})", said(ended->errors), ended->exit_code));
    return ended->output;
}

std::string gnuplot_string(std::string_view text) {
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? std::string{"''"} : std::string{c};
    return result + "'";
}

}  // namespace sr::course
