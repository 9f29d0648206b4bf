/// @file style.cpp

#include "course/style.hpp"

#include <fmt/core.h>

#include <array>

#include "course/gnuplot.hpp"
#include "course/terminal.hpp"
#include "course/tex.hpp"

namespace sr::course {

namespace {

/// Of a letter, in units of the canvas.
double font_height(FontSize size) {
    constexpr std::array heights{18.0, 20.0, 16.0, 13.5};
    return heights[std::size_t(size)];
}

/// The printed picture is 16 cm wide; gnuplot's cairo terminals take a point of type for 1/72 in on a 96 dpi screen.
constexpr double points_per_unit = 16 / 2.54 * 72 / Canvas::width * 72 / 96;

}  // namespace

std::string_view hex(Ink ink) {
    constexpr std::array colours{"#0072b2", "#d55e00", "#00845f", "#b04a86",
                                 "#a07000", "#222222", "#2a8fc4", "#767676"};
    static_assert(colours.size() == inks);
    return colours[std::size_t(ink)];
}

double line_height(FontSize size) {
    return 1.3 * font_height(size);
}

double text_width(std::string_view tex, FontSize size) {
    constexpr double letter = 0.58;  // of the height, in DejaVu Sans, the widest of the usual fonts
    const double     bold   = size == FontSize::title ? 1.1 : 1;
    return letter * bold * font_height(size) * double(width(tex_to_plain(tex)));
}

std::vector<std::string> wrapped(std::string_view tex, FontSize size, double most) {
    std::vector<std::string> lines(1);
    std::string              word;
    bool                     formula  = false;
    const auto               end_word = [&] {
        const std::string longer = lines.back() + (lines.back().empty() ? "" : " ") + word;
        if (lines.back().empty() || text_width(longer, size) <= most)
            lines.back() = longer;
        else
            lines.push_back(word);
        word.clear();
    };
    for (const char c : tex) {
        if (c == '$' && !word.ends_with('\\')) formula = !formula;
        if (c == ' ' && !formula)
            end_word();
        else
            word += c;
    }
    end_word();
    return lines;
}

std::string Dialect::terminal(Canvas canvas) const {
    const double centimetres = 16 / Canvas::width;
    if (format_ == "svg")
        return fmt::format(
            "set terminal svg size {},{:.0f} enhanced font 'sans-serif,{}' background '#ffffff'",
            Canvas::width, canvas.height, font_height(FontSize::normal));
    if (format_ == "png")
        return fmt::format(
            "set terminal pngcairo size {},{:.0f} enhanced font 'sans-serif,{}' fontscale 1.5 "
            "linewidth 2 pointscale 2 background '#ffffff'",
            2 * Canvas::width, 2 * canvas.height, font_height(FontSize::normal));
    if (format_ == "pdf")
        return fmt::format(
            "set terminal pdfcairo size {}cm,{:.2f}cm enhanced font 'sans-serif,{}' fontscale {:.4f} "
            "background '#ffffff'",
            16, canvas.height * centimetres, font_height(FontSize::normal), points_per_unit);
    return fmt::format("set terminal tikz size {}cm,{:.2f}cm font '\\small'", 16,
                       canvas.height * centimetres);
}

std::string Dialect::text(std::string_view tex) const {
    return gnuplot_string(tex_ ? tex_to_latex(tex) : tex_to_enhanced(tex));
}

std::string Dialect::font(FontSize size) const {
    constexpr std::array latex{"\\bfseries", "\\large", "\\small", "\\footnotesize"};
    if (tex_) return fmt::format("font '{}'", latex[std::size_t(size)]);
    return fmt::format("font '{},{}'", size == FontSize::title ? "sans-serif:Bold" : "sans-serif",
                       font_height(size));
}

std::string Dialect::finished(std::string picture) const {
    const auto replace = [&](std::string_view old, std::string_view by) {
        const std::size_t at = picture.find(old);
        if (at != std::string::npos) picture.replace(at, old.size(), by);
    };
    if (format_ == "svg") {
        replace("<svg", "<svg xml:space=\"preserve\"");  // else viewers drop the spaces between two faces
        replace("<title>Gnuplot</title>\n", "");         // a browser would show it over the whole picture
    }
    return (tex_ ? "% needs \\usepackage{gnuplot-lua-tikz}\n" : "") + picture;
}

}  // namespace sr::course
