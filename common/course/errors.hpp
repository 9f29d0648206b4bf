#pragma once
/// @file errors.hpp
/// How a program of the course says that something is wrong.

#include <exception>
#include <string>
#include <string_view>
#include <vector>

namespace sr::course {

inline constexpr int claim_failed = 1;
inline constexpr int bad_input    = 2;

/// One line on stderr: "01_rays: error: --size 0: ...". @return bad_input, the exit code that goes with it
int report_error(std::string_view program, const std::exception& error);

/// "; did you mean --size?" when one of `known` differs from `word` in few letters, or else nothing.
[[nodiscard]] std::string did_you_mean(std::string_view word, const std::vector<std::string>& known);

}  // namespace sr::course
