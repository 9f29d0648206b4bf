#pragma once
/// @file style.hpp
/// How every figure of the course looks: colours, fonts, sizes, in this one place.

#include <string>
#include <string_view>
#include <vector>

namespace sr::course {

/// Colours that people with any colour vision tell apart: those of Okabe and Ito (2008), the light ones darkened
/// until each has a contrast of at least 3:1 against white. The order is that of a chart's curves.
enum class Ink { blue, vermilion, green, purple, amber, black, sky, grey };
inline constexpr int inks = 8;

/// "#0072b2"
[[nodiscard]] std::string_view hex(Ink ink);

/// A picture's size in the unit of everything in it: 800 across, whether it is 800 pixels or 16 cm wide.
struct Canvas {
    static constexpr double width  = 800;
    double                  height = 500;
};

enum class FontSize { title, diagram, normal, small };

/// Height of the letters' line, and a guess at the width of a text, a little too wide rather than too narrow.
[[nodiscard]] double line_height(FontSize size);
[[nodiscard]] double text_width(std::string_view tex, FontSize size);

/// The lines of a text no wider than `width`, broken at spaces that are not in a formula.
[[nodiscard]] std::vector<std::string> wrapped(std::string_view tex, FontSize size, double width);

/// A picture format's own words for gnuplot: svg, png, pdf or tex.
class Dialect {
public:
    explicit Dialect(std::string_view format) : tex_{format == "tex"}, format_{format} {}

    [[nodiscard]] std::string terminal(Canvas canvas) const;     ///< "set terminal ..."
    [[nodiscard]] std::string text(std::string_view tex) const;  ///< a label, quoted
    [[nodiscard]] std::string font(FontSize size) const;         ///< "font '...'"
    /// What gnuplot drew, with what it leaves out; a .tex says which package it needs.
    [[nodiscard]] std::string finished(std::string picture) const;

private:
    bool        tex_;
    std::string format_;
};

}  // namespace sr::course
