/// @file layers.cpp
/// The arrows between the folders of common/ run one way, and no chapter leans on another.

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "scratch_folder.hpp"

namespace {

namespace fs = std::filesystem;
using sr::test::read_text;
using Names    = std::set<std::string>;
using Includes = std::vector<std::string>;

const fs::path common = fs::path(STERADIAN_SOURCE_DIR) / "common";

/// What a folder may include beside itself and math.
const std::map<std::string, Names> arrows = {
    {"math", {}},
    {"statistics", {}},
    {"sampling", {}},
    {"geometry", {}},
    {"radiometry", {"geometry"}},
    {"material", {"sampling", "radiometry"}},
    {"image", {"radiometry"}},
    {"scene", {"sampling", "geometry", "radiometry", "material", "image"}},
    {"radiosity", {"sampling", "geometry", "radiometry", "material", "image", "scene"}},
    {"transport", {"statistics", "sampling", "geometry", "radiometry", "material", "image", "scene"}},
    {"course", {"image", "radiometry", "statistics"}},  // radiometry: an image's pixels are spectra
};

/// The files that a text includes in quotes, or in angle brackets.
Includes includes(const std::string& text, char open = '"', char close = '"') {
    std::istringstream lines(text);
    Includes           found;
    for (std::string line; std::getline(lines, line);) {
        const std::size_t start = line.find_first_not_of(" \t");
        if (start == std::string::npos || line[start] != '#') continue;
        if (line.find("include") == std::string::npos) continue;
        const std::size_t from = line.find(open);
        if (from != std::string::npos)
            found.push_back(line.substr(from + 1, line.find(close, from + 1) - from - 1));
    }
    return found;
}

/// The includes of a file in `folder` that no arrow allows.
Includes against_the_arrows(const std::string& folder, const std::string& text) {
    Includes wrong = includes(text);
    std::erase_if(wrong, [&](const std::string& file) {
        const std::string other = file.substr(0, file.find('/'));
        return other == folder || other == "math" || arrows.at(folder).contains(other);
    });
    return wrong;
}

/// The includes of a chapter's file that are neither in common/ nor in the chapter.
Includes from_elsewhere(const fs::path& chapter, const std::string& text) {
    Includes wrong = includes(text);
    std::erase_if(wrong, [&](const std::string& file) {
        return !file.starts_with("..") && (fs::exists(common / file) || fs::exists(chapter / file));
    });
    return wrong;
}

std::vector<fs::path> sources(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (const fs::path type = entry.path().extension(); type == ".hpp" || type == ".cpp")
            files.push_back(entry.path());
    return files;
}

}  // namespace

TEST_CASE("each folder includes only what its arrows point to") {
    int seen = 0;
    for (const auto& entry : fs::directory_iterator(common)) {
        if (!entry.is_directory()) continue;
        const std::string folder = entry.path().filename().string();
        REQUIRE_MESSAGE(arrows.contains(folder), folder << " has no row in the table of arrows");
        for (const fs::path& file : sources(entry.path())) {
            const std::string text = read_text(file);
            INFO(file.string());
            CHECK(against_the_arrows(folder, text) == Includes{});
            for (const std::string& included : includes(text)) {
                INFO(included);
                CHECK(fs::exists(common / included));
                ++seen;
            }
        }
    }
    CHECK(seen > 20);
}

TEST_CASE("an include against an arrow is found") {
    CHECK(against_the_arrows("geometry", "#include \"math/frame.hpp\"\n") == Includes{});
    CHECK(against_the_arrows("geometry", "// below\n#include \"scene/scene.hpp\"\n") ==
          Includes{"scene/scene.hpp"});
    CHECK(against_the_arrows("image", "#include \"geometry/mesh.hpp\"\n") == Includes{"geometry/mesh.hpp"});
    CHECK(against_the_arrows("scene", " # include \"statistics/running.hpp\"") ==
          Includes{"statistics/running.hpp"});
    CHECK(against_the_arrows("transport", "#include \"course/chart.hpp\"\n") == Includes{"course/chart.hpp"});
    CHECK(against_the_arrows("course", "#include \"geometry/box.hpp\"\n") == Includes{"geometry/box.hpp"});
    CHECK(against_the_arrows("radiosity", "#include \"transport/tiles.hpp\"\n") ==
          Includes{"transport/tiles.hpp"});
}

TEST_CASE("a chapter includes only common/ and its own files") {
    int seen = 0;
    for (const auto& entry : fs::directory_iterator(fs::path(STERADIAN_SOURCE_DIR) / "chapters")) {
        if (!entry.is_directory()) continue;
        for (const fs::path& file : sources(entry.path())) {
            INFO(file.string());
            CHECK(from_elsewhere(entry.path(), read_text(file)) == Includes{});
            ++seen;
        }
    }
    CHECK(seen >= 1);

    const fs::path chapter = fs::path(STERADIAN_SOURCE_DIR) / "chapters" / "01_rays";
    CHECK(from_elsewhere(chapter, "#include \"scenes.hpp\"\n#include \"math/frame.hpp\"\n") == Includes{});
    for (const std::string file : {"../01_rays/scenes.hpp", "tests/child.hpp", "run_course.hpp"})
        CHECK(from_elsewhere(chapter, "#include \"" + file + "\"\n") == Includes{file});
}

TEST_CASE("the option parser, slow to compile, is included once") {
    int count = 0;
    for (const char* const folder : {"common", "chapters", "tests"})
        for (const fs::path& file : sources(fs::path(STERADIAN_SOURCE_DIR) / folder))
            for (const std::string& included : includes(read_text(file), '<', '>'))
                if (included.starts_with("CLI/")) ++count;
    CHECK(count == 1);
}
