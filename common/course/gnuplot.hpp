#pragma once
/// @file gnuplot.hpp
/// gnuplot as a function from a script to a picture.

#include <optional>
#include <string>
#include <string_view>

namespace sr::course {

/// Runs gnuplot, without the person's own settings, and returns what the script draws on its standard output;
/// nothing where there is none on the PATH.
/// @throws std::runtime_error "gnuplot: ..." with its own words when it can't draw the script
[[nodiscard]] std::optional<std::string> run_gnuplot(std::string_view script);

/// `text` between single quotes, as gnuplot reads a string.
[[nodiscard]] std::string gnuplot_string(std::string_view text);

}  // namespace sr::course
