/// @file table.cpp

#include "course/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "course/number.hpp"
#include "course/terminal.hpp"

namespace sr::course {

namespace {

/// `text` in a column of `columns`, its spaces on the left or the right.
std::string padded(const std::string& text, std::size_t columns, bool right) {
    const std::string spaces(columns - width(text), ' ');
    return right ? spaces + text : text + spaces;
}

}  // namespace

std::string four_digits(const std::vector<Cell>& row, std::size_t column) {
    const Cell& cell = row[column];
    if (!cell.is_number()) return cell.text();
    const double number   = cell.number();
    const bool   is_whole = number == std::trunc(number) && std::abs(number) < 1e15;
    return is_whole ? whole(std::int64_t(number)) : fmt::format("{:.4g}", number);
}

std::string to_text(const Rows& table, const CellText& shown) {
    const std::size_t        columns = table.header.size();
    std::vector<std::size_t> widths(columns);
    std::vector<bool>        numbers(columns, false);
    for (std::size_t c = 0; c < columns; ++c) {
        widths[c] = width(table.header[c]);
        for (const auto& row : table.rows) {
            widths[c]  = std::max(widths[c], width(shown(row, c)));
            numbers[c] = numbers[c] || row[c].is_number();
        }
    }

    std::string text;
    const auto  line = [&](const auto& cell) {
        std::string joined;
        for (std::size_t c = 0; c < columns; ++c)
            joined += (c == 0 ? "  " : "   ") + padded(cell(c), widths[c], numbers[c]);
        joined.erase(joined.find_last_not_of(' ') + 1);
        return joined;
    };
    text += emphasise(line([&](std::size_t c) { return table.header[c]; }), Emphasis::strong) + '\n';
    for (const auto& row : table.rows) text += line([&](std::size_t c) { return shown(row, c); }) + '\n';
    return text;
}

void print(const Rows& table) {
    fmt::print("{}", to_text(table));
}

}  // namespace sr::course
