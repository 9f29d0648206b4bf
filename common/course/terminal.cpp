/// @file terminal.cpp

#include "course/terminal.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace sr::course {

bool stdout_is_terminal() {
    return ::isatty(1) != 0;
}
bool stderr_is_terminal() {
    return ::isatty(2) != 0;
}

std::string emphasise(std::string_view text, Emphasis emphasis) {
    const char* no_colour = std::getenv("NO_COLOR");
    if (!stdout_is_terminal() || (no_colour != nullptr && *no_colour != '\0')) return std::string{text};
    const char* codes[] = {"1", "32", "1;31"};
    return fmt::format("\x1b[{}m{}\x1b[0m", codes[int(emphasis)], text);
}

std::size_t width(std::string_view utf8) {
    // of a code point's bytes, all but the first look like 10xxxxxx
    const auto starts = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; };
    return std::size_t(std::count_if(utf8.begin(), utf8.end(), starts));
}

}  // namespace sr::course
