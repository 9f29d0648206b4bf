#include "image/whole_file.hpp"

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

#ifdef _WIN32
#include <io.h>
#include <process.h>
#else
#include <unistd.h>
#endif

namespace sr {

namespace {

// The names of the temporaries, where a signal handler can read them: no allocation, no lock of a library.
struct Slot {
    bool                   used = false;
    std::array<char, 4096> path = {};
};
std::array<Slot, 64> slots;
std::atomic_flag     slots_in_use;

#ifndef _WIN32
sigset_t interrupts() {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGINT);
    sigaddset(&set, SIGTERM);
    return set;
}
#endif

/// Holds the slots. The thread takes no interrupt meanwhile, so that the handler, which takes the slots as
/// well and never gives them back, can't wait for its own thread.
class SlotsLock {
public:
    SlotsLock() {
#ifndef _WIN32
        const sigset_t blocked = interrupts();
        pthread_sigmask(SIG_BLOCK, &blocked, &before_);
#endif
        while (slots_in_use.test_and_set()) {
        }
    }
    ~SlotsLock() {
        slots_in_use.clear();
#ifndef _WIN32
        pthread_sigmask(SIG_SETMASK, &before_, nullptr);
#endif
    }
    SlotsLock(const SlotsLock&)            = delete;
    SlotsLock& operator=(const SlotsLock&) = delete;

private:
#ifndef _WIN32
    sigset_t before_ = {};
#endif
};

extern "C" void remove_temporaries_and_end(int signal) {
    while (slots_in_use.test_and_set()) {
    }
    for (const Slot& slot : slots)
        if (slot.used) ::unlink(slot.path.data());
    std::_Exit(128 + signal);
}

[[noreturn]] void fail(const std::filesystem::path& path, int error) {
    throw std::runtime_error("cannot write " + path.string() + ": " + std::strerror(error));
}

/// A new file beside its target. It is removed, by the destructor or by an interrupt, unless it was renamed.
class Temporary {
public:
    explicit Temporary(const std::filesystem::path& target) : target_{target} {
        static std::atomic<unsigned> count = 0;
        path_                              = target;
        path_.replace_filename("." + target.filename().string() + "." + std::to_string(::getpid()) + "." +
                               std::to_string(++count));
        const SlotsLock lock;
        slot_ = free_slot();
        file_ = std::fopen(path_.string().c_str(), "wbx");
        if (file_ == nullptr) fail(target_, errno);
        slot_->used = true;
    }
    ~Temporary() {
        if (file_ != nullptr) std::fclose(file_);
        const SlotsLock lock;
        if (slot_->used) std::remove(slot_->path.data());
        slot_->used = false;
    }
    Temporary(const Temporary&)            = delete;
    Temporary& operator=(const Temporary&) = delete;

    void write(std::string_view bytes) {
        if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size() || std::fflush(file_) != 0)
            fail(target_, errno);
    }

    void rename_to_target() {
        // a full disk behind a network shows only now
        if (std::fclose(std::exchange(file_, nullptr)) != 0) fail(target_, errno);
        const SlotsLock lock;
        std::error_code error;
        std::filesystem::rename(path_, target_, error);
        if (error) throw std::runtime_error("cannot write " + target_.string() + ": " + error.message());
        slot_->used = false;
    }

private:
    Slot* free_slot() {
        const std::string name = path_.string();
        for (Slot& slot : slots) {
            if (slot.used || name.size() >= slot.path.size()) continue;
            slot.path[name.copy(slot.path.data(), name.size())] = '\0';
            return &slot;
        }
        throw std::runtime_error("cannot write " + target_.string() +
                                 ": its name is too long, or too many files are being written at once");
    }

    std::filesystem::path target_;
    std::filesystem::path path_;
    Slot*                 slot_ = nullptr;
    std::FILE*            file_ = nullptr;
};

/// A device or pipe can't be replaced by a file.
void write_in_place(const std::filesystem::path& path, std::string_view bytes) {
    std::FILE* file = std::fopen(path.string().c_str(), "wb");
    if (file == nullptr) fail(path, errno);
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
    const int  error   = errno;
    if (std::fclose(file) != 0) fail(path, errno);
    if (!written) fail(path, error);
}

}  // namespace

void write_whole_file(const std::filesystem::path& path, std::string_view bytes) {
    std::error_code unknown;
    const auto      status = std::filesystem::status(path, unknown);
    if (std::filesystem::is_other(status)) return write_in_place(path, bytes);
    if (std::filesystem::is_directory(status)) fail(path, EISDIR);

    Temporary file{path};
    file.write(bytes);
    file.rename_to_target();
}

void end_cleanly_on_interrupt() {
#ifdef _WIN32
    std::signal(SIGINT, remove_temporaries_and_end);
#else
    struct sigaction action = {};
    action.sa_handler       = remove_temporaries_and_end;
    action.sa_mask          = interrupts();  // the second must not wait for the first, inside it
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    std::signal(SIGXFSZ, SIG_IGN);
#endif
}

}  // namespace sr
