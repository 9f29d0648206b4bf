/// @file progress.cpp

#include "course/progress.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>

#include "course/terminal.hpp"

namespace sr::course {

namespace {

constexpr double       worth_showing = 2;    // [s]
constexpr std::int64_t redraw        = 100;  // [ms]

}  // namespace

Progress::Progress(std::string what, int steps)
    : what_{std::move(what)}, steps_{std::max(1, steps)}, visible_{stderr_is_terminal()} {}

Progress::~Progress() {
    if (drawn_) fmt::print(stderr, "\r\x1b[K");
}

void Progress::tick(int steps) {
    const int done = done_.fetch_add(steps, std::memory_order_relaxed) + steps;
    if (!visible_) return;
    const double elapsed = std::chrono::duration<double>(Clock::now() - start_).count();
    const auto   now     = std::int64_t(1000 * elapsed);
    auto         next    = next_.load(std::memory_order_relaxed);
    // of all threads that are late, the one that moves the next time draws
    if (now >= next && next_.compare_exchange_strong(next, now + redraw)) draw(done, elapsed);
}

void Progress::tick_part(int done, int of) {
    tick(steps_of_part(steps_, done, of));
}

void Progress::draw(int done, double elapsed) {
    const std::string line = progress_line(what_, double(done) / double(steps_), elapsed);
    if (line.empty()) return;
    drawn_ = true;
    fmt::print(stderr, "\r\x1b[K{}", line);
    std::fflush(stderr);
}

int steps_of_part(int steps, int part, int of) {
    const auto up_to = [&](std::int64_t parts) { return int(steps * parts / of); };
    return up_to(part) - up_to(part - 1);
}

std::string progress_line(const std::string& what, double fraction, double elapsed) {
    constexpr int cells = 24;
    if (!(fraction > 0) || elapsed < 0.2 || elapsed / fraction < worth_showing) return "";
    const double done   = std::min(fraction, 1.0);
    const int    filled = int(done * cells);
    const double left   = elapsed / done - elapsed;
    const auto   time   = left < 90 ? fmt::format("{:.0f} s", left) : fmt::format("{:.0f} min", left / 60);
    return fmt::format("{} [{:=<{}}{:{}}] {:3.0f} %, {} left", what, "", filled, "", cells - filled,
                       100 * done, time);
}

}  // namespace sr::course
