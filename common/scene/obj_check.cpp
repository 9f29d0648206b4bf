/// @file obj_check.cpp

#include "scene/obj_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "scene/obj_statements.hpp"
#include "scene/text_file.hpp"

namespace sr {
namespace {

using std::filesystem::path;

template <class... Values>
[[noreturn]] void refuse(const path& file, const Statement& statement, fmt::format_string<Values...> problem,
                         Values&&... values) {
    throw std::runtime_error(fmt::format("{}:{}: ", file.string(), statement.line) +
                             fmt::format(problem, std::forward<Values>(values)...));
}

/// A word for an error message, which must stay one line that can be read.
std::string in_quotes(std::string_view word) {
    return word.size() <= 40 ? fmt::format("'{}'", word) : fmt::format("'{}...'", word.substr(0, 37));
}

/// A decimal number that float can hold; in every locale.
std::optional<double> parse_number(std::string_view word) {
    if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);  // from_chars knows no plus
    double value            = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size()) return {};
    if (!(std::abs(value) <= std::numeric_limits<float>::max())) return {};  // nor nan and inf
    return value;
}

/// The numbers after the keyword.
std::vector<double> numbers(const path& file, const Statement& statement) {
    std::vector<double> values;
    for (const std::string_view word : std::span(statement.words).subspan(1)) {
        const auto value = parse_number(word);
        if (!value)
            refuse(file, statement,
                   "{} after {}; must be a finite number that float can hold, such as -1.5e3",
                   in_quotes(word), statement.words[0]);
        values.push_back(*value);
    }
    return values;
}

/// The one word after `usemtl` or `newmtl`.
std::string name(const path& file, const Statement& statement) {
    if (statement.words.size() != 2) {
        refuse(file, statement, "{} with {} words after it; must be one name without blanks",
               statement.words[0], statement.words.size() - 1);
    }
    return std::string(statement.words[1]);
}

/// The materials of all MTL files of an OBJ file.
struct Library {
    std::string                        text;
    std::set<std::string, std::less<>> names;

    void add(const path& file) {
        bool in_material = false;
        for_each_statement(read_text(file), [&](const Statement& statement) {
            const std::string_view keyword = statement.words[0];
            if (keyword == "newmtl") {
                in_material = true;
                add_name(file, statement);
            } else if (keyword == "Kd" || keyword == "Ke") {
                if (!in_material) refuse(file, statement, "{} of no material; must follow newmtl", keyword);
                add_colour(file, statement);
            }
        });
    }

private:
    void add_name(const path& file, const Statement& statement) {
        const auto [it, is_new] = names.insert(name(file, statement));
        if (!is_new) refuse(file, statement, "a second material {}; names must differ", in_quotes(*it));
        text += fmt::format("newmtl {0}\nKd {1} {1} {1}\n", *it, default_reflectance);
    }

    void add_colour(const path& file, const Statement& statement) {
        const auto   rgb   = numbers(file, statement);
        const bool   Kd    = statement.words[0] == "Kd";
        const double limit = Kd ? 1 : std::numeric_limits<double>::infinity();
        const bool good = std::all_of(rgb.begin(), rgb.end(), [&](double v) { return v >= 0 && v <= limit; });
        if (rgb.size() != 3 || !good) {
            refuse(file, statement, "{} must be three numbers {}", Kd ? "reflectance Kd" : "emission Ke",
                   Kd ? "from 0 to 1" : "of 0 or more");
        }
        text += fmt::format("{} {}\n", statement.words[0], fmt::join(rgb, " "));
    }
};

/// What a face may refer to, wherever in the file it is.
struct Known {
    long long vertices = 0;
    Library   library;
};

Known known(const path& file, std::string_view text) {
    Known found;
    for_each_statement(text, [&](const Statement& statement) {
        if (statement.words[0] == "v") ++found.vertices;
        if (statement.words[0] != "mtllib") return;
        const auto        words = std::span(statement.words).subspan(1);
        const std::string name  = fmt::format("{}", fmt::join(words, " "));
        const path        mtl   = file.parent_path() / name;
        std::error_code   error;
        if (words.empty() || !is_regular_file(mtl, error)) {
            refuse(file, statement, "no file {}; mtllib must name one MTL file, seen from here",
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
        refuse(file, statement, "face corner {}; must be a vertex number such as 7, -1 or 7/1/2",
               in_quotes(corner));
    }
    if (index < 0 && index < -above) {
        refuse(file, statement, "face corner {}; must be -1 to -{}, counted back over the vertices above",
               in_quotes(corner), above);
    }
    if (index == 0 || index > all) {
        refuse(file, statement, "face corner {}; must be 1 to {}, the file's vertices", in_quotes(corner),
               all);
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
            add_vertex(statement);
        } else if (keyword == "f") {
            add_face(statement);
        } else if (keyword == "usemtl") {
            use_material(statement);
        } else if (std::find(passed_over.begin(), passed_over.end(), keyword) == passed_over.end()) {
            refuse(file, statement, "unknown statement {}; must be v, f or another of polygon OBJ",
                   in_quotes(keyword));
        }
    }

private:
    void add_vertex(const Statement& statement) {
        const auto values = numbers(file, statement);
        if (values.size() < 3) {
            refuse(file, statement, "vertex of {} numbers; must be x y z", values.size());
        }
        kept += fmt::format("v {} {} {}\n", values[0], values[1], values[2]);
        ++vertices;
    }

    /// A polygon becomes the fan (0,1,2), (0,2,3), ...
    void add_face(const Statement& statement) {
        std::vector<long long> corners;
        for (const std::string_view corner : std::span(statement.words).subspan(1)) {
            corners.push_back(vertex_number(file, statement, corner, vertices, known.vertices));
        }
        if (corners.size() < 3) {
            refuse(file, statement, "face of {} corners; must be 3 or more", corners.size());
        }
        for (std::size_t i = 2; i < corners.size(); ++i) {
            kept += fmt::format("f {} {} {}\n", corners[0], corners[i - 1], corners[i]);
        }
        ++faces;
    }

    void use_material(const Statement& statement) {
        const std::string material = name(file, statement);
        if (!known.library.names.contains(material)) {
            refuse(file, statement, "material {}; must be a newmtl of an MTL file that mtllib names",
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
            fmt::format("{}: no faces; must have a line such as f 1 2 3", file.string()));
    }
    if (checker.known.library.names.empty()) return {checker.kept, {}};
    return {"mtllib checked\n" + checker.kept, checker.known.library.text};
}

}  // namespace sr
