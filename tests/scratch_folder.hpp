#pragma once
/// @file scratch_folder.hpp

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace sr::test {

/// A folder of its own for a test; gone afterwards.
class ScratchFolder {
public:
    explicit ScratchFolder(const std::string& name)
        : path{std::filesystem::temp_directory_path() / (name + "_" + std::to_string(::getpid()))} {
        std::filesystem::remove_all(path);
        std::filesystem::create_directories(path);
    }
    ~ScratchFolder() { std::filesystem::remove_all(path); }
    ScratchFolder(const ScratchFolder&)            = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    /// How many files lie in it, hidden ones too.
    [[nodiscard]] long files() const {
        return std::distance(std::filesystem::directory_iterator{path},
                             std::filesystem::directory_iterator{});
    }

    const std::filesystem::path path;
};

inline std::string read_text(const std::filesystem::path& path) {
    std::ifstream file{path, std::ios::binary};
    return {std::istreambuf_iterator<char>{file}, {}};
}

}  // namespace sr::test
