#pragma once
/// @file csv.hpp
/// Comma-separated values (RFC 4180, lines end in \n): how every result is kept.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace sr::course {

/// One value of a table. A whole number of any type is a `std::int64_t`.
class Cell {
public:
    Cell(std::string text) : value_(std::move(text)) {}
    Cell(std::string_view text) : value_(std::string(text)) {}
    Cell(const char* text) : value_(std::string(text)) {}
    Cell(double number) : value_(number) {}
    Cell(float number) : value_(number) {}
    Cell(bool truth) : value_(std::string(truth ? "yes" : "no")) {}
    template <std::integral T>
    Cell(T number) : value_(std::int64_t(number)) {}

    /// A number in the fewest digits that read back as the same number, a text as it is; in every locale.
    [[nodiscard]] std::string text() const;

    /// The value of a number; NaN for a text.
    [[nodiscard]] double number() const;
    [[nodiscard]] bool   is_number() const { return !std::holds_alternative<std::string>(value_); }

private:
    std::variant<std::string, double, float, std::int64_t> value_;
};

/// Rows under named columns.
struct Rows {
    std::vector<std::string>       header;
    std::vector<std::vector<Cell>> rows = {};

    /// @throws std::invalid_argument when the row has not one cell for each column
    void add(std::vector<Cell> row);

    /// The place of a column. @throws std::invalid_argument naming the columns there are
    [[nodiscard]] std::size_t column(std::string_view name) const;
};

/// The table as a CSV file holds it; fields with a comma, quote or line break are quoted.
[[nodiscard]] std::string to_csv(const Rows& table);

/// Writes the table, whole or not at all.
void write_csv(const std::filesystem::path& path, const Rows& table);

/// Reads a CSV with a header; a field that reads as a number and was not quoted is one.
/// @throws std::runtime_error with file and row (the header is row 1) where a row is shorter or longer than
/// the header
[[nodiscard]] Rows read_csv(const std::filesystem::path& path);

}  // namespace sr::course
