#pragma once
/// @file progress.hpp

#include <atomic>
#include <chrono>
#include <cstdint>
#include <string>

namespace sr::course {

/// How far a long operation is, on stderr, with the time left: only on a terminal, and only where the whole
/// will take over two seconds. Any number of threads may tick; a tick is an atomic addition and a look at the
/// clock. The line is gone when the object is.
///     Progress progress{"rendering", tiles};
///     ... progress.tick();
class Progress {
public:
    Progress(std::string what, int steps);
    ~Progress();
    Progress(const Progress&)            = delete;
    Progress& operator=(const Progress&) = delete;

    /// One more step (or more than one) is done.
    void tick(int steps = 1);

    /// Of all steps' work, shared out to `of` equal parts, the `done`-th part is done: what TileLoop::on_tile tells.
    void tick_part(int done, int of);

private:
    using Clock = std::chrono::steady_clock;

    void draw(int done, double elapsed);

    std::string               what_;
    int                       steps_;
    bool                      visible_;
    Clock::time_point         start_ = Clock::now();
    std::atomic<int>          done_  = 0;
    std::atomic<std::int64_t> next_  = 0;  ///< when the line is drawn again [ms since the start]
    std::atomic<bool>         drawn_ = false;
};

/// How many of so many steps are done with the `part`-th of equal parts: all with the last, whatever is left over.
/// @pre 1 <= part <= of
[[nodiscard]] int steps_of_part(int steps, int part, int of);

/// What the line says: "rendering  42 %, 13 s left". Empty while the whole is estimated at under two seconds.
[[nodiscard]] std::string progress_line(const std::string& what, double fraction, double elapsed);

}  // namespace sr::course
