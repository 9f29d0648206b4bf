/// @file number.cpp

#include "course/number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sr::course {

namespace {

constexpr std::string_view hard_space = "\u00a0";

/// The power of ten of the first digit.
int exponent_of(double value) {
    return int(std::floor(std::log10(std::abs(value))));
}

}  // namespace

std::string whole(std::int64_t number) {
    std::string       text  = fmt::format("{}", number);
    const std::size_t first = text.starts_with('-') ? 1 : 0;
    if (text.size() - first < 5) return text;
    for (std::size_t at = text.size() - 3; at > first && at < text.size(); at -= 3)
        text.insert(at, hard_space);
    return text;
}

std::string counted(std::int64_t number, std::string_view thing) {
    return fmt::format("{} {}{}", whole(number), thing, number == 1 ? "" : "s");
}

std::string to_tolerance(double value, double tolerance) {
    if (value == std::trunc(value) && std::abs(value) < 1e15) return whole(std::int64_t(value));
    if (!(std::isfinite(value) && tolerance > 0)) return fmt::format("{}", value);
    const int exponent = exponent_of(value);
    const int digits   = std::clamp(exponent - exponent_of(tolerance) + 1, 2, 17);
    if (exponent < -4 || exponent > 15) return fmt::format("{:.{}e}", value, digits - 1);
    return fmt::format("{:.{}f}", value, std::max(digits - 1 - exponent, 0));
}

}  // namespace sr::course
