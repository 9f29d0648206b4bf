/// @file csv.cpp

#include "course/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <limits>
#include <optional>
#include <stdexcept>

#include "image/whole_file.hpp"

namespace sr::course {

namespace {

std::string quoted_if_needed(const Cell& cell) {
    std::string text = cell.text();
    if (cell.is_number() || text.find_first_of(",\"\r\n") == std::string::npos) return text;
    for (std::size_t at = 0; (at = text.find('"', at)) != std::string::npos; at += 2) text.insert(at, 1, '"');
    return '"' + text + '"';
}

/// A field as it was read: "7" in quotes is a text, 7 is a number.
struct Field {
    std::string text;
    bool        quoted = false;
};

/// The part after a field's opening quote, up to the closing one; a doubled quote is one.
std::string read_quoted(std::istream& in) {
    std::string text;
    for (char c; in.get(c); text += c)
        if (c == '"' && in.peek() != '"')
            return text;
        else if (c == '"')
            in.get();
    throw std::runtime_error("a quote is opened and not closed");
}

/// The fields of the next row; none at the end of the file.
std::optional<std::vector<Field>> read_row(std::istream& in) {
    if (in.peek() == std::istream::traits_type::eof()) return std::nullopt;
    std::vector<Field> fields(1);
    for (char c; in.get(c) && c != '\n';) {
        if (c == ',')
            fields.emplace_back();
        else if (c == '"' && fields.back().text.empty())
            fields.back() = {read_quoted(in), true};
        else if (c != '\r')
            fields.back().text += c;
    }
    return fields;
}

Cell cell_of(const Field& field) {
    const char*  end = field.text.data() + field.text.size();
    std::int64_t whole{};
    double       number{};
    if (field.quoted || field.text.empty()) return field.text;
    const bool negative_zero = field.text == "-0";  // only a real number has one
    if (const auto r = std::from_chars(field.text.data(), end, whole);
        r.ec == std::errc{} && r.ptr == end && !negative_zero)
        return whole;
    if (const auto r = std::from_chars(field.text.data(), end, number); r.ec == std::errc{} && r.ptr == end)
        return number;
    return field.text;
}

}  // namespace

std::string Cell::text() const {
    return std::visit([](const auto& value) { return fmt::format("{}", value); }, value_);
}

double Cell::number() const {
    if (const auto* d = std::get_if<double>(&value_)) return *d;
    if (const auto* f = std::get_if<float>(&value_)) return *f;
    if (const auto* i = std::get_if<std::int64_t>(&value_)) return double(*i);
    return std::numeric_limits<double>::quiet_NaN();
}

void Rows::add(std::vector<Cell> row) {
    if (row.size() != header.size())
        throw std::invalid_argument(fmt::format("a row of {} cells for the {} columns {}", row.size(),
                                                header.size(), fmt::join(header, ", ")));
    rows.push_back(std::move(row));
}

std::size_t Rows::column(std::string_view name) const {
    const auto found = std::find(header.begin(), header.end(), name);
    if (found == header.end())
        throw std::invalid_argument(fmt::format("no column {}; there are {}", name, fmt::join(header, ", ")));
    return std::size_t(found - header.begin());
}

std::string to_csv(const Rows& table) {
    std::string csv;
    const auto  line = [&](const auto& cells) {
        const char* separator = "";
        for (const auto& cell : cells) {
            csv += separator + quoted_if_needed(cell);
            separator = ",";
        }
        csv += '\n';
    };
    line(table.header);
    for (const auto& row : table.rows) line(row);
    return csv;
}

void write_csv(const std::filesystem::path& path, const Rows& table) {
    write_whole_file(path, to_csv(table));
}

Rows read_csv(const std::filesystem::path& path) {
    std::ifstream file{path, std::ios::binary};
    if (!file) throw std::runtime_error(fmt::format("cannot read {}", path.string()));
    Rows        table;
    std::size_t line = 1;
    try {
        const auto header = read_row(file);
        if (!header) throw std::runtime_error("the file is empty; a header must come first");
        for (const Field& field : *header) table.header.push_back(field.text);
        for (line = 2; const auto fields = read_row(file); ++line) {
            std::vector<Cell> cells;
            for (const Field& field : *fields) cells.push_back(cell_of(field));
            table.add(std::move(cells));
        }
    } catch (const std::exception& error) {
        throw std::runtime_error(fmt::format("{}, row {}: {}", path.string(), line, error.what()));
    }
    return table;
}

}  // namespace sr::course
