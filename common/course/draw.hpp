#pragma once
/// @file draw.hpp
/// The gnuplot scripts of charts and diagrams: everything about how they look, nothing of what they say, which is in
/// the CSV that the script reads.

#include <filesystem>
#include <string>
#include <string_view>

#include "course/chart.hpp"
#include "course/diagram.hpp"

namespace sr::course {

/// @param csv     the rows of grouped_by_series(chart)
/// @param format  svg, png, pdf or tex
[[nodiscard]] std::string chart_script(const ChartData& chart, const std::filesystem::path& csv,
                                       std::string_view format);

/// @param csv  the rows of to_rows(diagram)
[[nodiscard]] std::string diagram_script(const DiagramData& diagram, const std::filesystem::path& csv,
                                         std::string_view format);

}  // namespace sr::course
