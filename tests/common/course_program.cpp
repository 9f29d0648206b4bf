#include "course/program.hpp"

#include <doctest/doctest.h>

#include <stdexcept>

#include "child.hpp"

using namespace sr::course;
using sr::test::in_child;

TEST_CASE("a program's lines are handed on, the last without its end too") {
    std::vector<std::string> lines;
    const int                code = run_program({"sh", "-c", "echo one; echo two >&2; printf three; exit 7"},
                                                [&](std::string_view line) { lines.emplace_back(line); });
    CHECK(code == 7);
    CHECK(lines == std::vector<std::string>{"one", "two", "three"});
    CHECK_THROWS_WITH_AS((void)run_program({"no_such_program"}, [](std::string_view) {}),
                         "cannot run no_such_program: No such file or directory", std::runtime_error);
}

TEST_CASE("what is thrown over a line comes through when the program has ended, and leaves nothing behind") {
    const Ended ended = in_child([] {
        const int free = ::dup(0);  // the next descriptor
        ::close(free);
        bool thrown = false;
        try {
            (void)run_program({"sh", "-c", "while echo y; do :; done"},
                              [](std::string_view) { throw std::runtime_error("enough"); });
        } catch (const std::runtime_error& error) {
            thrown = std::string_view{error.what()} == "enough";
        }
        const bool waited_for = ::waitpid(-1, nullptr, WNOHANG) == -1 && errno == ECHILD;
        const bool closed     = ::dup(0) == free;
        return (thrown ? 1 : 0) + (waited_for ? 2 : 0) + (closed ? 4 : 0);
    });
    CHECK(ended.code == 7);
}
