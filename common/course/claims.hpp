#pragma once
/// @file claims.hpp

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "course/chapter.hpp"

namespace sr::course {

/// A section's claims: its number, what the text says, and half of the last digit in which it says so.
struct Claims {
    Chapter&    chapter;
    std::string section;

    void operator()(std::string_view what, double expected, double measured, double tolerance) const {
        chapter.claim(fmt::format("{} {}", section, what),
                      {.expected = expected, .measured = measured, .tolerance = tolerance});
    }
};

}  // namespace sr::course
