#pragma once
/// @file obj_check.hpp
/// What stands between a file and the OBJ library. The library turns "nan", "abc" and lines that are too
/// short into 0 without a word, so each statement is looked at before it gets there.

#include <filesystem>
#include <string>
#include <vector>

namespace sr {

/// An OBJ file and its MTL files, checked and reduced to v, f, usemtl and newmtl, illum, Kd, Ks, Ns, Ke, Ni. What
/// the library reads is therefore what was checked: indices count from 1, faces are triangles, names are one word.
struct CheckedObj {
    std::string              obj;
    std::string              mtl;    ///< all libraries of the file, one after the other
    std::vector<std::string> notes;  ///< what is taken otherwise than it is written
};

/// @throws std::runtime_error of one line, "file:line: what is wrong; what would be right"
[[nodiscard]] CheckedObj check_obj(const std::filesystem::path& path);

}  // namespace sr
