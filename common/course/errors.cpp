/// @file errors.cpp

#include "course/errors.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <numeric>
#include <utility>

namespace sr::course {

namespace {

/// Letters to insert, remove or replace to get from `a` to `b` (Levenshtein), row by row of the table.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i + 1);
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal                   = row[j + 1];
            row[j + 1]                 = std::min({replaced, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

/// What it says. The file system's own words come as "filesystem error: cannot ...: Permission denied [/a] [/b]".
std::string message_of(const std::exception& error) {
    const auto* const files = dynamic_cast<const std::filesystem::filesystem_error*>(&error);
    return files ? fmt::format("{}: {}", files->path1().string(), files->code().message()) : error.what();
}

}  // namespace

int report_error(std::string_view program, const std::exception& error) {
    std::string line = message_of(error);
    std::replace(line.begin(), line.end(), '\n', ' ');
    fmt::print(stderr, "{}: error: {}\n", program, line);
    return bad_input;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& known) {
    const auto closer = [&](const std::string& a, const std::string& b) {
        return edit_distance(word, a) < edit_distance(word, b);
    };
    const auto nearest = std::min_element(known.begin(), known.end(), closer);
    if (nearest == known.end() || edit_distance(word, *nearest) > 1 + word.size() / 4) return "";
    return fmt::format("; did you mean {}?", *nearest);
}

}  // namespace sr::course
