/// @file interruptible.cpp

#include "course/interruptible.hpp"

#include <atomic>
#include <csignal>

namespace sr::course {
namespace {

std::atomic<bool> noted = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may touch no other");

#ifdef _WIN32

void (*before)(int) = SIG_DFL;

extern "C" void note_interrupt(int) {
    noted = true;
    std::signal(SIGINT, before);
}
void set_note() {
    before = std::signal(SIGINT, note_interrupt);
}
void set_before() {
    std::signal(SIGINT, before);
}

#else

struct sigaction before = {};

extern "C" void note_interrupt(int) {
    noted = true;
    sigaction(SIGINT, &before, nullptr);
}
void set_note() {
    struct sigaction action = {};
    action.sa_handler       = note_interrupt;
    action.sa_flags         = SA_RESTART;
    sigaction(SIGINT, &action, &before);
}
void set_before() {
    sigaction(SIGINT, &before, nullptr);
}

#endif

}  // namespace

Interruptible::Interruptible() {
    noted = false;
    set_note();
}

Interruptible::~Interruptible() {
    set_before();
}

bool Interruptible::asked() const {
    return noted;
}

}  // namespace sr::course
