/// @file gnuplot.cpp

#include "course/gnuplot.hpp"

#include <fmt/core.h>

#include <sstream>
#include <stdexcept>

#include "course/program.hpp"

namespace sr::course {

namespace {

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

}  // namespace

std::optional<std::string> run_gnuplot(std::string_view script) {
    const std::optional<Ended> ended = filter_through({"gnuplot", "-d", "-"}, script);
    if (!ended) return std::nullopt;
    if (ended->code != 0 || ended->out.empty())
        throw std::runtime_error(fmt::format("gnuplot: {} (exit code {})", said(ended->err), ended->code));
    return ended->out;
}

std::string gnuplot_string(std::string_view text) {
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? std::string{"''"} : std::string{c};
    return result + "'";
}

}  // namespace sr::course
