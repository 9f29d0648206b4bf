#pragma once
/// @file factor_methods.hpp
/// The ways to compute a form factor that section 8.3 compares.

#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "course/style.hpp"
#include "math/square.hpp"
#include "radiosity/cosine_rays.hpp"
#include "radiosity/exchange_area.hpp"
#include "radiosity/hemicube.hpp"
#include "radiosity/point_form_factors.hpp"
#include "radiosity/visible_share.hpp"
#include "unit_squares.hpp"

namespace sr {

/// A patch cut into n x n.
[[nodiscard]] inline std::vector<Patch> pieces_of(const Patch& patch, int n) {
    return cut(std::vector<Polygon>{{patch, {}, {}, 0}}, patch.longest_side() / n).shapes;
}

/// What two pieces are replaced by: point_form_factor, or disk_form_factor.
using PieceFactor = double (*)(const Patch& from, const Patch& to);

/// Both patches cut into n x n, and the pieces' form factors summed up. A ray says whether a pair counts.
[[nodiscard]] inline double summed_over_pieces(const Patch& from, const Patch& to, int n, PieceFactor factor,
                                               const Visibility* visibility = nullptr) {
    const auto these = pieces_of(from, n), those = pieces_of(to, n);
    double     sum = 0;
    for (const Patch& a : these)
        for (const Patch& b : those)
            if (!visibility || visibility->between(a.surface_point(a.centre()), b.surface_point(b.centre())))
                sum += factor(a, b);
    return sum / double(these.size());
}

/// From the middles of n x n pieces, by their contour.
[[nodiscard]] inline double summed_contours(const Patch& from, const Patch& to, int n) {
    double     sum   = 0;
    const auto these = pieces_of(from, n);
    for (const Patch& a : these) sum += contour_form_factor(a.centre(), a.normal(), to);
    return sum / double(these.size());
}

/// A method's colour, the same on all charts.
[[nodiscard]] inline course::Ink ink_of_method(std::string_view method) {
    using course::Ink;
    static const std::map<std::string_view, Ink> inks{
        {"points", Ink::blue},
        {"disks", Ink::vermilion},
        {"contour", Ink::green},
        {"contour, adaptive", Ink::purple},
        {"contour and rays", Ink::purple},  // the same, times a share
        {"random pairs", Ink::amber},
        {"cosine rays", Ink::black},
        {"hemicube", Ink::sky}};
    return inks.at(method);
}

/// A method, with more effort or less.
struct FactorMethod {
    std::string         name;
    std::vector<double> efforts;  ///< points, pairs, rays, pixels, or one over the tolerance
    bool                by_chance;
    std::function<double(double effort, Rng& rng)> compute;
};

/// Those that can be used on the pair. Without occlusion, visibility is not asked for; with it, the contour formula
/// knows only how much would be seen, and rays say which share of it is.
/// @pre the pair and what is made of it outlive the methods
[[nodiscard]] inline std::vector<FactorMethod> factor_methods(const KnownPair&  pair,
                                                              const Visibility& visibility,
                                                              const CosineRays& rays) {
    const bool        occluded = pair.patches.size() > 2;
    const Visibility* asked    = occluded ? &visibility : nullptr;
    const auto        side     = [](double effort) { return int(std::lround(std::sqrt(effort))); };
    const auto        pieces   = [&pair, asked, side](PieceFactor factor) {
        return [&pair, asked, side, factor](double effort, Rng&) {
            return summed_over_pieces(pair.from(), pair.to(), side(std::sqrt(effort)), factor, asked);
        };
    };
    const std::vector<double> pairs{1, 16, 256, 4096, 50625}, squares{4, 16, 64, 256, 1024, 4096};
    std::vector<FactorMethod> methods{{"points", pairs, false, pieces(point_form_factor)},
                                      {"disks", pairs, false, pieces(disk_form_factor)}};
    if (occluded) {
        methods.push_back({"contour and rays", squares, true, [&, side](double effort, Rng& rng) {
                               return exchange_area(pair.from(), pair.to(), 1e-4) / pair.from().area() *
                                      visible_share(pair.from(), pair.to(), visibility, side(effort), rng);
                           }});
    } else {
        methods.push_back({"contour", {1, 4, 16, 64, 256, 1024, 4096}, false, [&, side](double effort, Rng&) {
                               return summed_contours(pair.from(), pair.to(), side(effort));
                           }});
        methods.push_back(
            {"contour, adaptive", {1e2, 1e3, 1e4, 1e5, 1e6, 1e7}, false, [&](double effort, Rng&) {
                 return exchange_area(pair.from(), pair.to(), 1 / effort) / pair.from().area();
             }});
    }
    methods.push_back({"random pairs", squares, true, [&, side](double effort, Rng& rng) {
                           return sampled_form_factor(pair.from(), pair.to(), visibility, side(effort), rng);
                       }});
    methods.push_back({"cosine rays", squares, true,
                       [&, side](double effort, Rng& rng) { return rays.row(0, side(effort), rng)[1]; }});
    methods.push_back({"hemicube", {192, 768, 3072, 12288, 49152}, false, [&, side](double effort, Rng&) {
                           return Hemicube(pair.patches, side(effort / 3)).row(0)[1];
                       }});
    return methods;
}

}  // namespace sr
