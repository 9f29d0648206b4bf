#pragma once
/// @file style.hpp
/// How every figure of the course looks: colours, fonts, sizes, in this one place.

#include <array>
#include <string_view>

namespace sr::course {

/// Colours that people with any colour vision tell apart (Okabe & Ito, 2008; yellow, too light for a line on
/// white, left out and sky blue darkened), each at least 3:1 against white.
enum class Ink { black, blue, vermilion, green, purple, amber, sky, grey };

/// "#0072b2"
[[nodiscard]] std::string_view hex(Ink ink);

/// The inks of a chart's curves, in order.
inline constexpr std::array curve_inks{Ink::blue,  Ink::vermilion, Ink::green, Ink::purple,
                                       Ink::amber, Ink::sky,       Ink::black, Ink::grey};

}  // namespace sr::course
