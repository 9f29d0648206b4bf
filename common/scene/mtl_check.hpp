#pragma once
/// @file mtl_check.hpp

#include <array>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "scene/obj_statements.hpp"

namespace sr {

/// Reflectance where a file names none: a neutral grey [1].
inline constexpr double default_reflectance = 0.8;

/// Phong's exponent where a file names none [1].
inline constexpr double default_exponent = 20;

/// What `illum`, the number of an illumination model, comes to.
enum class MtlModel { diffuse, phong, mirror, glass };
[[nodiscard]] MtlModel mtl_model(int illum);

/// The materials of all MTL files of an OBJ file, each checked when its statements are complete.
class MtlLibrary {
public:
    /// @throws std::runtime_error of one line, "file:line: what is wrong; what would be right"
    void add(const std::filesystem::path& file);

    [[nodiscard]] bool contains(std::string_view material) const { return names_.contains(material); }
    [[nodiscard]] bool empty() const { return names_.empty(); }

    /// All of them, reduced to newmtl, illum, Kd, Ks, Ns, Ke, Ni.
    [[nodiscard]] const std::string& text() const { return text_; }

    /// What is taken otherwise than it is written, "file:line: what is done instead" of each material.
    [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }

private:
    /// The material whose statements are being read, and the line that began it.
    struct Draft {
        int                   line  = 0;
        std::string           name  = {};
        int                   illum = 0;
        std::array<double, 3> Kd{default_reflectance, default_reflectance, default_reflectance};
        std::array<double, 3> Ks{};
        double                Ns = default_exponent;
        std::array<double, 3> Ke{};
        double                Ni = 1.5;
    };

    void begin(const std::filesystem::path& file, const Statement& statement);
    void property(const std::filesystem::path& file, const Statement& statement);
    void end(const std::filesystem::path& file);
    void limit_reflectance(const std::filesystem::path& file);

    Draft                              draft_;
    std::set<std::string, std::less<>> names_;
    std::string                        text_;
    std::vector<std::string>           notes_;
};

}  // namespace sr
