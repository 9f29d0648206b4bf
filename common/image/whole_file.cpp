/// @file whole_file.cpp

#include "image/whole_file.hpp"

#include <fcntl.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#ifdef _WIN32
#include <direct.h>
#include <io.h>
#include <process.h>
#else
#include <unistd.h>
#endif

namespace sr {

namespace {

/// Text where a signal handler can read it: no allocation, no lock of a library.
using Text = std::array<char, 4096>;

void set(Text& text, std::string_view to) {
    text[to.copy(text.data(), text.size() - 1)] = '\0';
}

/// The name of a temporary.
struct Slot {
    bool used = false;
    Text path = {};
};
std::array<Slot, 64> slots;
Text                 last_folder = {}, last_words = {};
std::atomic_flag     slots_in_use;  // and what is said and done last

#ifndef _WIN32
sigset_t interrupts() {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGINT);
    sigaddset(&set, SIGTERM);
    sigaddset(&set, SIGPIPE);
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
        while (slots_in_use.test_and_set()) std::this_thread::yield();
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

void tidy_up() {
    while (slots_in_use.test_and_set()) {
    }
    for (const Slot& slot : slots)
        if (slot.used) ::unlink(slot.path.data());
    if (last_folder[0] != '\0') ::rmdir(last_folder.data());  // does nothing to one that is not empty
}

extern "C" void tidy_up_and_say_so(int signal) {
    tidy_up();
    (void)!::write(2, last_words.data(), unsigned(std::strlen(last_words.data())));
    std::_Exit(128 + signal);
}

#ifndef _WIN32
extern "C" void tidy_up_and_end(int signal) {
    tidy_up();
    std::_Exit(128 + signal);
}
#endif

#ifdef O_BINARY
constexpr int binary = O_BINARY;  // Windows would write \r\n
#else
constexpr int binary = 0;
#endif

[[noreturn]] void fail(const std::filesystem::path& path, int error) {
    throw std::runtime_error("cannot write " + path.string() + ": " + std::strerror(error));
}

/// An open file, without a library's buffer: what the disk refuses is told here and not later.
class OpenFile {
public:
    OpenFile(const char* path, int how) : descriptor_{::open(path, how, 0666)} {}
    ~OpenFile() {
        if (is_open()) ::close(descriptor_);
    }
    OpenFile(const OpenFile&)            = delete;
    OpenFile& operator=(const OpenFile&) = delete;

    [[nodiscard]] bool is_open() const { return descriptor_ >= 0; }

    /// @return 0, or errno
    [[nodiscard]] int write(std::string_view bytes) {
        while (!bytes.empty()) {
            const auto written =
                ::write(descriptor_, bytes.data(), std::min<std::size_t>(bytes.size(), 1 << 20));
            if (written < 0 && errno != EINTR) return errno;
            if (written > 0) bytes.remove_prefix(std::size_t(written));
        }
        return 0;
    }

    /// A full disk behind a network shows only now. @return 0, or errno
    [[nodiscard]] int close() { return ::close(std::exchange(descriptor_, -1)) == 0 ? 0 : errno; }

private:
    int descriptor_;
};

/// A name beside the target. What lies under it is removed, by the destructor or by an interrupt, unless it was
/// renamed. The lock is held around bare system calls only: a thread that the handler interrupts may hold a lock
/// of the allocator, and whoever waited for that here would never give the slots free.
class Temporary {
public:
    explicit Temporary(const std::filesystem::path& target) : target_{target} {
        static std::atomic<unsigned> count = 0;
        path_                              = target;
        path_.replace_filename("." + target.filename().string() + "." + std::to_string(::getpid()) + "." +
                               std::to_string(++count));
        name_ = path_.string();
        const SlotsLock lock;
        for (Slot& slot : slots)
            if (!slot.used && name_.size() < slot.path.size()) slot_ = &slot;
        if (slot_ == nullptr) return;
        set(slot_->path, name_);
        slot_->used = true;
    }
    ~Temporary() {
        if (slot_ == nullptr) return;
        const SlotsLock lock;
        ::unlink(name_.c_str());  // not there any more after a renaming
        slot_->used = false;
    }
    Temporary(const Temporary&)            = delete;
    Temporary& operator=(const Temporary&) = delete;

    void write(std::string_view bytes) {
        if (slot_ == nullptr) fail(target_, ENAMETOOLONG);
        std::optional<OpenFile> file;
        int                     error = 0;
        {
            const SlotsLock lock;  // nothing is made once the handler has looked
            file.emplace(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | binary);
            error = file->is_open() ? 0 : errno;
        }
        if (error == 0) error = file->write(bytes);
        if (error == 0) error = file->close();
        if (error != 0) fail(target_, error);
    }

    void rename_to_target() {
        std::error_code error;
        {
            const SlotsLock lock;
            std::filesystem::rename(path_, target_, error);
        }
        if (error) fail(target_, error.value());
    }

private:
    std::filesystem::path target_;
    std::filesystem::path path_;
    std::string           name_;  // the same, for the system calls
    Slot*                 slot_ = nullptr;
};

/// A device or pipe can't be replaced by a file.
void write_in_place(const std::filesystem::path& path, std::string_view bytes) {
    OpenFile  file{path.string().c_str(), O_WRONLY | binary};
    const int opened  = file.is_open() ? 0 : errno;
    const int written = opened != 0 ? opened : file.write(bytes);
    const int closed  = written != 0 ? written : file.close();
    if (closed != 0) fail(path, closed);
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

void on_interrupt(const std::filesystem::path& folder, std::string_view words) {
    const std::string name = folder.string();
    const SlotsLock   lock;
    set(last_folder, name.size() < last_folder.size() ? name : "");
    set(last_words, words);
}

void end_cleanly_on_interrupt() {
#ifdef _WIN32
    std::signal(SIGINT, tidy_up_and_say_so);
#else
    struct sigaction action = {};
    action.sa_handler       = tidy_up_and_say_so;
    action.sa_mask          = interrupts();  // the second must not wait for the first, inside it
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    action.sa_handler = tidy_up_and_end;
    sigaction(SIGPIPE, &action, nullptr);
    std::signal(SIGXFSZ, SIG_IGN);
#endif
}

}  // namespace sr
