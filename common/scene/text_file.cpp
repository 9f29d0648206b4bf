/// @file text_file.cpp

#include "scene/text_file.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace sr {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& path, const char* problem) {
    throw std::runtime_error(fmt::format("{}: {}", path.string(), problem));
}

/// Control characters that no text holds: the mark of a picture or an archive under the wrong name.
bool is_binary(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte == 0x7f || (byte < 0x20 && !(byte >= '\t' && byte <= '\r'));
}

}  // namespace

std::string read_text(const std::filesystem::path& path) {
    std::error_code ignored;
    const auto      status = std::filesystem::status(path, ignored);
    if (!exists(status)) refuse(path, "no such file; must be a text file");
    if (is_directory(status)) refuse(path, "is a directory; must be a text file");
    if (!is_regular_file(status)) refuse(path, "is a device or a pipe; must be a text file");

    std::ifstream      in(path, std::ios::binary);
    std::ostringstream all;
    if (!in) refuse(path, "can't be opened; must be readable");
    if (in.peek() != std::ifstream::traits_type::eof()) all << in.rdbuf();
    if (in.bad() || all.fail()) refuse(path, "can't be read to its end");

    std::string text = std::move(all).str();
    if (text.empty()) refuse(path, "is empty; must be a text file");
    const auto binary = std::find_if(text.begin(), text.end(), is_binary);
    if (binary != text.end()) {
        const auto line = 1 + std::count(text.begin(), binary, '\n');
        throw std::runtime_error(fmt::format("{}:{}: holds the byte {:#04x}; must be a text file",
                                             path.string(), line, static_cast<unsigned char>(*binary)));
    }
    return text;
}

}  // namespace sr
