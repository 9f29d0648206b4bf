/// @file mtl_check.cpp

#include "scene/mtl_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "scene/obj_words.hpp"
#include "scene/text_file.hpp"

namespace sr {
namespace {

using std::filesystem::path;

/// What a property of a material is, and what it would have to be.
[[noreturn]] void refuse_value(const path& file, const Statement& statement, std::string_view right) {
    const auto values = fmt::format("{}", fmt::join(std::span(statement.words).subspan(1), " "));
    refuse(file, statement.line, "{} is {}; must be {}", statement.words[0], in_quotes(values), right);
}

/// The three numbers after the keyword.
std::array<double, 3> colour(const path& file, const Statement& statement, std::string_view right,
                             double limit) {
    const auto rgb  = numbers_of(file, statement);
    const bool good = std::ranges::all_of(rgb, [&](double v) { return v >= 0 && v <= limit; });
    if (rgb.size() != 3 || !good) refuse_value(file, statement, right);
    return {rgb[0], rgb[1], rgb[2]};
}

std::array<double, 3> reflectance(const path& file, const Statement& statement) {
    return colour(file, statement, "a reflectance, three numbers from 0 to 1", 1);
}

std::array<double, 3> emission(const path& file, const Statement& statement) {
    return colour(file, statement, "a radiance, three numbers of 0 or more",
                  std::numeric_limits<double>::infinity());
}

/// The one number after the keyword.
double number(const path& file, const Statement& statement, std::string_view right, auto is_right) {
    const auto values = numbers_of(file, statement);
    if (values.size() != 1 || !is_right(values[0])) refuse_value(file, statement, right);
    return values[0];
}

}  // namespace

MtlModel mtl_model(int illum) {
    switch (illum) {
        case 2:
            return MtlModel::phong;
        case 3:
        case 5:
            return MtlModel::mirror;
        case 4:
        case 6:
        case 7:
        case 9:
            return MtlModel::glass;
        default:
            return MtlModel::diffuse;
    }
}

void MtlLibrary::add(const path& file) {
    for_each_statement(read_text(file), [&](const Statement& statement) {
        if (statement.words[0] == "newmtl") {
            end(file);
            begin(file, statement);
        } else {
            property(file, statement);
        }
    });
    end(file);
}

void MtlLibrary::begin(const path& file, const Statement& statement) {
    const auto [it, is_new] = names_.insert(name_of(file, statement));
    if (!is_new) refuse(file, statement.line, "a second material {}; names must differ", in_quotes(*it));
    draft_      = {};
    draft_.line = statement.line;
    draft_.name = *it;
}

void MtlLibrary::property(const path& file, const Statement& statement) {
    const std::string_view                    keyword = statement.words[0];
    constexpr std::array<std::string_view, 6> known{"Kd", "Ks", "Ns", "Ke", "Ni", "illum"};
    if (std::ranges::find(known, keyword) == known.end()) return;
    if (draft_.name.empty()) refuse(file, statement.line, "{} of no material; must follow newmtl", keyword);
    if (keyword == "Kd") draft_.Kd = reflectance(file, statement);
    if (keyword == "Ks") draft_.Ks = reflectance(file, statement);
    if (keyword == "Ns")
        draft_.Ns = number(file, statement, "the exponent of highlights from 0 to 1000000, such as 20",
                           [](double e) { return e >= 0 && e <= 1e6; });
    if (keyword == "Ke") draft_.Ke = emission(file, statement);
    if (keyword == "Ni")
        draft_.Ni = number(file, statement, "an index of refraction from 0.001 to 10, such as 1.5 for glass",
                           [](double n) { return n >= 0.001 && n <= 10; });
    if (keyword == "illum")
        draft_.illum =
            int(number(file, statement, "the number of an illumination model, 0 to 10, such as 4 for glass",
                       [](double n) { return n >= 0 && n <= 10 && n == int(n); }));
}

void MtlLibrary::end(const path& file) {
    if (draft_.name.empty()) return;
    limit_reflectance(file);
    const auto& [line, name, illum, Kd, Ks, Ns, Ke, Ni] = draft_;
    text_ += fmt::format("newmtl {}\nillum {}\nKd {}\nKs {}\nNs {}\nKe {}\nNi {}\n", name, illum,
                         fmt::join(Kd, " "), fmt::join(Ks, " "), Ns, fmt::join(Ke, " "), Ni);
    draft_ = {};
}

/// What reflects more light than it gets can't be. Of highlights, which many programs write so, the colours hold; a
/// mirror is refused.
void MtlLibrary::limit_reflectance(const path& file) {
    auto& [line, name, illum, Kd, Ks, Ns, Ke, Ni] = draft_;
    const MtlModel model                          = mtl_model(illum);
    if (model != MtlModel::phong && model != MtlModel::mirror) return;
    const double most = std::max({Kd[0] + Ks[0], Kd[1] + Ks[1], Kd[2] + Ks[2]});
    if (most <= 1) return;
    const auto what = fmt::format("material {} reflects Kd + Ks = {}", in_quotes(name), most);
    if (model == MtlModel::mirror) refuse(file, line, "{}; must be at most 1", what);
    for (auto* const weights : {&Kd, &Ks})
        for (double& weight : *weights) weight /= most;
    notes_.push_back(fmt::format("{}:{}: {}; both are divided by that", file.string(), line, what));
}

}  // namespace sr
