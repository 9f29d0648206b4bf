/// @file obj_check.cpp

#include "scene/obj_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <span>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "math/vector.hpp"
#include "scene/fan.hpp"
#include "scene/mtl_check.hpp"
#include "scene/obj_statements.hpp"
#include "scene/obj_words.hpp"
#include "scene/text_file.hpp"

namespace sr {
namespace {

using std::filesystem::path;

/// What a face may refer to, wherever in the file it is.
struct Known {
    std::vector<Vector3<double>> vertices;
    MtlLibrary                   library;
};

Vector3<double> vertex_of(const path& file, const Statement& statement) {
    const auto values = numbers_of(file, statement);
    if (values.size() < 3) refuse(file, statement.line, "vertex of {} numbers; must be x y z", values.size());
    return {values[0], values[1], values[2]};
}

Known known(const path& file, std::string_view text) {
    Known found;
    for_each_statement(text, [&](const Statement& statement) {
        if (statement.words[0] == "v") found.vertices.push_back(vertex_of(file, statement));
        if (statement.words[0] != "mtllib") return;
        const auto        words = std::span(statement.words).subspan(1);
        const std::string name  = fmt::format("{}", fmt::join(words, " "));
        const path        mtl   = file.parent_path() / name;
        std::error_code   error;
        if (words.empty() || !is_regular_file(mtl, error)) {
            refuse(file, statement.line, "no file {}; mtllib must name one MTL file, seen from here",
                   in_quotes(name));
        }
        found.library.add(mtl);
    });
    return found;
}

/// The number, counted from 1, of the vertex that "7", "7/1/2" or "-1" names.
/// @param above  vertices that the file has up to here: -1 is the last of them
long long vertex_number(const path& file, const Statement& statement, std::string_view corner,
                        long long above, long long all) {
    const std::string_view digits = corner.substr(0, corner.find('/'));
    long long              index  = 0;
    const auto [end, error]       = std::from_chars(digits.data(), digits.data() + digits.size(), index);
    if (error != std::errc{} || end != digits.data() + digits.size()) {
        refuse(file, statement.line, "face corner {}; must be a vertex number such as 7, -1 or 7/1/2",
               in_quotes(corner));
    }
    if (index < 0 && index < -above) {
        refuse(file, statement.line,
               "face corner {}; must be -1 to -{}, counted back over the vertices above", in_quotes(corner),
               above);
    }
    if (index == 0 || index > all) {
        refuse(file, statement.line, "face corner {}; must be 1 to {}, the file's vertices",
               in_quotes(corner), all);
    }
    return index < 0 ? above + 1 + index : index;
}

/// Looks at the statements of an OBJ file in turn and keeps those that the library is to read.
struct ObjChecker {
    const path& file;
    Known       known;
    std::string kept;
    long long   vertices = 0;
    long long   faces    = 0;

    void check(const Statement& statement) {
        static constexpr std::array<std::string_view, 18> passed_over{
            "mtllib", "vn",  "vt",     "vp",     "g",     "s",        "mg",       "o",          "p",
            "l",      "lod", "maplib", "usemap", "bevel", "c_interp", "d_interp", "shadow_obj", "trace_obj"};
        const std::string_view keyword = statement.words[0];
        if (keyword == "v") {
            add_vertex(known.vertices[std::size_t(vertices)]);
        } else if (keyword == "f") {
            add_face(statement);
        } else if (keyword == "usemtl") {
            use_material(statement);
        } else if (std::find(passed_over.begin(), passed_over.end(), keyword) == passed_over.end()) {
            refuse(file, statement.line, "unknown statement {}; must be v, f or another of polygon OBJ",
                   in_quotes(keyword));
        }
    }

private:
    void add_vertex(const Vector3<double>& position) {
        kept += fmt::format("v {} {} {}\n", position.x, position.y, position.z);
        ++vertices;
    }

    void add_face(const Statement& statement) {
        const auto             words = std::span(statement.words).subspan(1);
        const auto             all   = std::ssize(known.vertices);
        std::vector<long long> corners;
        for (const std::string_view corner : words)
            corners.push_back(vertex_number(file, statement, corner, vertices, all));
        if (corners.size() < 3)
            refuse(file, statement.line, "face of {} corners; must be 3 or more", corners.size());
        const auto first = fan_corner(positions_of(corners));
        if (!first)
            refuse(file, statement.line,
                   "face of {} corners that no corner sees whole; must be cut into convex ones",
                   corners.size());
        std::rotate(corners.begin(), corners.begin() + std::ptrdiff_t(*first), corners.end());
        for (std::size_t i = 2; i < corners.size(); ++i)
            kept += fmt::format("f {} {} {}\n", corners[0], corners[i - 1], corners[i]);
        ++faces;
    }

    std::vector<Vector3<double>> positions_of(const std::vector<long long>& corners) const {
        std::vector<Vector3<double>> positions;
        for (const long long corner : corners) positions.push_back(known.vertices[std::size_t(corner - 1)]);
        return positions;
    }

    void use_material(const Statement& statement) {
        const std::string material = name_of(file, statement);
        if (!known.library.contains(material)) {
            refuse(file, statement.line, "material {}; must be a newmtl of an MTL file that mtllib names",
                   in_quotes(material));
        }
        kept += fmt::format("usemtl {}\n", material);
    }
};

}  // namespace

CheckedObj check_obj(const path& file) {
    const std::string text = read_text(file);
    ObjChecker        checker{file, known(file, text), {}};
    for_each_statement(text, [&](const Statement& statement) { checker.check(statement); });
    if (checker.faces == 0) {
        throw std::runtime_error(
            fmt::format("{}: has no faces; must have a line such as f 1 2 3", file.string()));
    }
    const MtlLibrary& library = checker.known.library;
    if (library.empty()) return {checker.kept, {}, {}};
    return {"mtllib checked\n" + checker.kept, library.text(), library.notes()};
}

}  // namespace sr
