/// @file system_check.cpp

#include "radiosity/system_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "math/extremes.hpp"
#include "radiosity/residual.hpp"

namespace sr {
namespace {

using PatchSet = std::vector<std::size_t>;

constexpr double largest_finite = std::numeric_limits<double>::max();

void require(bool good, const std::string& what) {
    if (!good) throw std::invalid_argument(what);
}

void check_sizes(const RadiositySystem& system) {
    const std::size_t n    = system.size();
    const auto        same = [&](const char* what, std::size_t size) {
        require(size == n,
                       fmt::format("the system has {} {} for {} areas; there must be as many", size, what, n));
    };
    require(n > 0, "the system has no patches; must be at least one");
    same("rows of form factors", system.form_factors.size());
    same("reflectances", system.reflectance.size());
    same("emissions", system.emission.size());
}

void check_patch(const RadiositySystem& system, std::size_t i) {
    const auto& [r, g, b]    = system.reflectance[i];
    const auto& [er, eg, eb] = system.emission[i];
    require(each_in(system.reflectance[i], 0, 1),
            fmt::format("the reflectance of patch {} is ({}, {}, {}); must be 0 to 1", i, r, g, b));
    require(each_in(system.emission[i], 0, largest_finite),
            fmt::format("the emission of patch {} is ({}, {}, {}); must be 0 or more, and finite", i, er, eg,
                        eb));
    require(system.area[i] > 0 && system.area[i] <= largest_finite,
            fmt::format("the area of patch {} is {}; must be above 0, and finite", i, system.area[i]));
}

void check_row(const FormFactorMatrix& form_factors, std::size_t i, double tolerance) {
    const auto row = form_factors.row(i);
    for (std::size_t j = 0; j < row.size(); ++j)
        require(row[j] >= 0 && row[j] <= largest_finite,
                fmt::format("the form factor from patch {} to patch {} is {}; must be 0 to 1", i, j, row[j]));
    const double sum = form_factors.row_sum(i);
    require(sum <= 1 + tolerance,
            fmt::format(
                "the form factors from patch {} sum to {}; must be 1 at most (within {}), or light is made "
                "of nothing",
                i, sum, tolerance));
}

/// Where rows sum to more than 1, a patch may send on more than it gets. That is no harm while other patches absorb
/// more: light of 1 everywhere is followed until there is less everywhere.
void check_bounces(const RadiositySystem& system) {
    const std::size_t n     = system.size();
    std::size_t       worst = 0;
    const auto        gain  = [&](std::size_t i) {
        return largest(system.reflectance[i]) * system.form_factors.row_sum(i);
    };
    for (std::size_t i = 1; i < n; ++i)
        if (gain(i) > gain(worst)) worst = i;
    Radiosities   light(n, {1, 1, 1});
    constexpr int bounces = 1000;
    double        most    = gain(worst);
    for (int k = 1; k < bounces && !(most < 1); ++k) {
        Radiosities next(n);
        most = 0;
        for (std::size_t i = 0; i < n; ++i) {
            next[i] = system.reflectance[i] * irradiance(system.form_factors, light, i);
            most    = max_or_nan(most, largest(next[i]));
        }
        light = std::move(next);
    }
    require(
        most < 1,
        fmt::format("light gets no less in {} bounces, since form factors sum to more than 1: those of "
                    "patch {} to {}, and it reflects {}; must reflect less",
                    bounces, worst, system.form_factors.row_sum(worst), largest(system.reflectance[worst])));
}

/// Of one primary, the patches from which no light gets to one where some is lost.
std::vector<bool> keeping(const RadiositySystem& system, double DoubleSpectrum::*primary, double tolerance) {
    const std::size_t n = system.size();
    std::vector<bool> keeps(n, true);
    PatchSet          to_visit;
    const auto        loses = [&](std::size_t i) {
        keeps[i] = false;
        to_visit.push_back(i);
    };
    for (std::size_t i = 0; i < n; ++i) {
        const double rho = system.reflectance[i].*primary, sum = system.form_factors.row_sum(i);
        if (rho * sum < 1 && (rho < 1 || sum < 1 - tolerance)) loses(i);
    }
    while (!to_visit.empty()) {
        const std::size_t j = to_visit.back();
        to_visit.pop_back();
        for (std::size_t i = 0; i < n; ++i)
            if (keeps[i] && system.form_factors(i, j) > 0) loses(i);
    }
    return keeps;
}

/// The patches that are connected with the first one among those that are in, which are then out.
PatchSet take_connected(const FormFactorMatrix& form_factors, std::size_t first, std::vector<bool>& in) {
    PatchSet set{first};
    in[first] = false;
    for (std::size_t next = 0; next < set.size(); ++next) {
        const std::size_t i = set[next];
        for (std::size_t j = 0; j < in.size(); ++j) {
            if (!in[j] || !(form_factors(i, j) > 0 || form_factors(j, i) > 0)) continue;
            in[j] = false;
            set.push_back(j);
        }
    }
    std::sort(set.begin(), set.end());
    return set;
}

std::string names(const PatchSet& patches) {
    constexpr std::size_t most  = 12;
    const std::size_t     shown = std::min(patches.size(), most);
    std::string           text =
        fmt::format("{}", fmt::join(patches.begin(), patches.begin() + std::ptrdiff_t(shown), ", "));
    if (shown < patches.size()) text += fmt::format(" and {} more", patches.size() - shown);
    return text;
}

}  // namespace

std::vector<std::vector<std::size_t>> perfect_enclosures(const RadiositySystem& system, double tolerance) {
    std::vector<PatchSet> sets;
    for (const auto primary : {&DoubleSpectrum::r, &DoubleSpectrum::g, &DoubleSpectrum::b}) {
        auto keeps = keeping(system, primary, tolerance);
        for (std::size_t i = 0; i < keeps.size(); ++i)
            if (keeps[i]) sets.push_back(take_connected(system.form_factors, i, keeps));
    }
    std::sort(sets.begin(), sets.end());
    sets.erase(std::unique(sets.begin(), sets.end()), sets.end());
    return sets;
}

void check_system(const RadiositySystem& system, double tolerance) {
    check_sizes(system);
    for (std::size_t i = 0; i < system.size(); ++i) {
        check_patch(system, i);
        check_row(system.form_factors, i, tolerance);
    }
    const auto sets = perfect_enclosures(system, tolerance);
    if (!sets.empty())
        throw std::invalid_argument(fmt::format(
            "patches {} reflect all light, and only to each other: it never gets less, and there is no "
            "solution; one of them must have a reflectance below 1",
            names(sets.front())));
    check_bounces(system);
}

}  // namespace sr
