#include "image/whole_file.hpp"

#include <doctest/doctest.h>
#include <sys/resource.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "child.hpp"
#include "scratch_folder.hpp"

using namespace sr;
using namespace sr::test;

namespace {

/// What went wrong when `bytes` were written to `path`; empty when nothing did.
std::string complaint(const std::filesystem::path& path, std::string_view bytes) {
    try {
        write_whole_file(path, bytes);
    } catch (const std::exception& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("a whole file replaces the old one and leaves nothing beside it") {
    const ScratchFolder folder{"whole_file"};
    write_whole_file(folder.path / "x", "old and longer");
    write_whole_file(folder.path / "x", "new");
    CHECK(read_text(folder.path / "x") == "new");
    CHECK(folder.files() == 1);
}

TEST_CASE("a file that outgrows the disk is an error, and the old one stays") {
    const ScratchFolder folder{"whole_file_full"};
    write_whole_file(folder.path / "x", "old");
    const Ended ended = in_child([&] {
        const rlimit small{1000, 1000};
        ::setrlimit(RLIMIT_FSIZE, &small);
        end_cleanly_on_interrupt();
        return complaint(folder.path / "x", std::string(100'000, 'n')).ends_with("x: File too large") ? 0 : 1;
    });
    CHECK(ended.code == 0);
    CHECK(read_text(folder.path / "x") == "old");
    CHECK(folder.files() == 1);
}

TEST_CASE("what can't be written is said with its name and reason") {
    const ScratchFolder folder{"whole_file_bad"};
    CHECK(complaint("/dev/full", "x") == "cannot write /dev/full: No space left on device");
    CHECK(complaint("/dev/null", "x") == "");
    CHECK(std::filesystem::is_character_file("/dev/null"));  // written to, not replaced
    CHECK(complaint(folder.path, "x").ends_with(": Is a directory"));
    CHECK(complaint(folder.path / "no" / "x", "x").ends_with("x: No such file or directory"));
    CHECK(folder.files() == 0);
}

TEST_CASE("an interrupt in the middle of writing leaves the old file or the new one, and nothing else") {
    const ScratchFolder folder{"whole_file_interrupt"};
    const auto          path = folder.path / "x";
    const std::string   bytes(4 << 20, 'n');
    for (const int signal : {SIGINT, SIGTERM})
        for (int delay = 1; delay <= 8; ++delay) {
            write_whole_file(path, bytes);
            std::filesystem::remove(folder.path / "y");
            const Ended ended = in_child(
                [&] {
                    end_cleanly_on_interrupt();
                    std::jthread second{[&] {
                        for (;;) write_whole_file(folder.path / "y", bytes);
                    }};
                    for (;;) write_whole_file(path, bytes);
                    return 0;
                },
                [&](pid_t child) {
                    while (!std::filesystem::exists(folder.path / "y") && runs(child))
                        std::this_thread::yield();  // it writes now
                    std::this_thread::sleep_for(std::chrono::milliseconds(delay));
                    ::kill(child, signal);
                });
            CHECK(ended.code == 128 + signal);
            CHECK(std::filesystem::file_size(path) == bytes.size());
            CHECK(folder.files() <= 2);  // x and y, no temporary
        }
}
