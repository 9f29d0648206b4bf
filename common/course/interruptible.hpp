#pragma once
/// @file interruptible.hpp
/// Work that Ctrl-C ends early, and not in vain.

namespace sr::course {

/// While it lives, the first Ctrl-C ends nothing: it is noted, for a loop to stop where it can. The second ends the
/// program at once, as the first would have without this. No more than one lives at a time.
///     const Interruptible interrupt;
///     while (!done() && !interrupt.asked()) step();
///     ... save what there is
///     if (interrupt.asked()) throw Interrupted{};
class Interruptible {
public:
    Interruptible();
    ~Interruptible();
    Interruptible(const Interruptible&)            = delete;
    Interruptible& operator=(const Interruptible&) = delete;

    [[nodiscard]] bool asked() const;
};

/// Thrown by a lecture that was interrupted and has saved what there is: its chapter writes the figures and claims so
/// far, and the program ends as an interrupted one does.
struct Interrupted {};

}  // namespace sr::course
