/// @file chart.cpp

#include "course/chart.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sr::course {

namespace {

constexpr const char* no_value = "nan";  // where gnuplot interrupts a line; an empty field it would pass over

}  // namespace

Columns speed_accuracy(const std::vector<std::string>& more) {
    Columns columns{.headers = {"method", "effort", "seconds", "error", "error_se"},
                    .series  = "method",
                    .x       = "seconds",
                    .y       = "error",
                    .error   = "error_se"};
    columns.headers.insert(columns.headers.end(), more.begin(), more.end());
    return columns;
}

Axes with_error(Axes axes) {
    axes.columns = {.headers = {"series", axes.x, axes.y, "standard error"},
                    .series  = "series",
                    .x       = axes.x,
                    .y       = axes.y,
                    .error   = "standard error"};
    return axes;
}

Chart::Chart(std::string name, std::string title, Axes axes) {
    Columns& columns = axes.columns;
    if (columns.headers.empty())
        columns = {.headers = {"series", axes.x, axes.y}, .series = "series", .x = axes.x, .y = axes.y};
    Rows table{columns.headers};
    for (const std::string& drawn :
         {columns.series, columns.x, columns.y, columns.error, columns.min, columns.max})
        if (!drawn.empty())
            (void)table.column(drawn);  // a misspelt one is told here, before anything is measured
    data_ = std::make_shared<ChartData>(ChartData{.name  = std::move(name),
                                                  .title = std::move(title),
                                                  .axes  = std::move(axes),
                                                  .table = std::move(table)});
}

void Chart::add(std::string_view series, double x, double y, const std::vector<Cell>& more) {
    const Columns&    columns = data_->axes.columns;
    std::vector<Cell> cells;
    auto              next = more.begin();
    for (const std::string& header : columns.headers) {
        if (header == columns.series)
            cells.emplace_back(series);
        else if (header == columns.x)
            cells.emplace_back(x);
        else if (header == columns.y)
            cells.emplace_back(y);
        else if (next != more.end())
            cells.push_back(*next++);
    }
    cells.insert(cells.end(), next, more.end());
    row(std::move(cells));
}

void Chart::row(std::vector<Cell> cells) {
    const Columns& columns = data_->axes.columns;
    Rows           table{data_->table.header};  // apart, until the row is known to be good
    table.add(std::move(cells));
    const auto& row = table.rows.front();
    for (const std::string& drawn : {columns.x, columns.y, columns.error, columns.min, columns.max}) {
        if (drawn.empty()) continue;
        const Cell& value = row[table.column(drawn)];
        const bool  gap   = drawn != columns.x && !value.is_number() && value.text() == no_value;
        if (!gap && !std::isfinite(value.number()))
            throw std::invalid_argument(
                fmt::format("chart {}: {} has {} = {} at {} = {}; a curve needs finite numbers, or a gap()",
                            data_->name, row[table.column(columns.series)].text(), drawn, value.text(),
                            columns.x, row[table.column(columns.x)].text()));
    }
    data_->table.add(row);
}

void Chart::gap(std::string_view series, double x) {
    std::vector<Cell> cells(data_->table.header.size(), no_value);
    cells[data_->table.column(data_->axes.columns.series)] = series;
    cells[data_->table.column(data_->axes.columns.x)]      = x;
    row(std::move(cells));
}

double Chart::at(std::string_view series, double x) const {
    const Rows&    table   = data_->table;
    const Columns& columns = data_->axes.columns;
    for (const auto& cells : table.rows)
        if (cells[table.column(columns.series)].text() == series &&
            cells[table.column(columns.x)].number() == x)
            return cells[table.column(columns.y)].number();
    throw std::out_of_range(
        fmt::format("chart {}: nothing of {} at {} = {}", data_->name, series, columns.x, x));
}

Rows grouped_by_series(const ChartData& chart) {
    const std::size_t        column = chart.table.column(chart.axes.columns.series);
    std::vector<std::string> order;
    for (const auto& row : chart.table.rows)
        if (std::find(order.begin(), order.end(), row[column].text()) == order.end())
            order.push_back(row[column].text());

    Rows grouped{chart.table.header};
    for (const std::string& series : order)
        for (const auto& row : chart.table.rows)
            if (row[column].text() == series) grouped.add(row);
    return grouped;
}

}  // namespace sr::course
