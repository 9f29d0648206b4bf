#pragma once
/// @file text_file.hpp

#include <filesystem>
#include <string>

namespace sr {

/// All of a text file.
/// @throws std::runtime_error of one line if it is no regular file, can't be read, is empty or is not text
[[nodiscard]] std::string read_text(const std::filesystem::path& path);

}  // namespace sr
