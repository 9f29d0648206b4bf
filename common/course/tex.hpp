#pragma once
/// @file tex.hpp
/// The labels of figures are written once, in TeX: text with formulas between dollar signs, such as
/// "depth $t_{\min}$ of $\mathbf{o} + t\,\mathbf{d}$ [m]". Here they become what each kind of picture reads.
/// Outside of formulas every character stands for itself, except `\$` for a dollar sign.

#include <string>
#include <string_view>

namespace sr::course {

/// For gnuplot's SVG, PNG and PDF terminals: its "enhanced" text.
/// @throws std::invalid_argument naming a command that is not known, or a bracket or dollar that is not closed
[[nodiscard]] std::string tex_to_enhanced(std::string_view tex);

/// For gnuplot's tikz terminal: formulas as they are, the characters that LaTeX reads as commands escaped.
[[nodiscard]] std::string tex_to_latex(std::string_view tex);

/// For the page of figures.
[[nodiscard]] std::string tex_to_html(std::string_view tex);

/// Without any markup: to estimate a width, or for who cannot see the picture.
[[nodiscard]] std::string tex_to_plain(std::string_view tex);

}  // namespace sr::course
