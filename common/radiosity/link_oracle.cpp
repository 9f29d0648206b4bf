/// @file link_oracle.cpp

#include "radiosity/link_oracle.hpp"

#include <algorithm>
#include <cmath>

namespace sr {
namespace {

/// How far the radiosities of a node's children lie from its own; those below a leaf are one.
DoubleSpectrum spread(const Quadtrees& trees, const Radiosities& B, std::uint32_t node) {
    DoubleSpectrum most;
    if (trees[node].is_leaf()) return most;
    for (std::size_t k = trees[node].first_child; k < trees[node].first_child + 4; ++k) {
        const DoubleSpectrum d = magnitude(B[k] - B[node]);
        most                   = {std::max(most.r, d.r), std::max(most.g, d.g), std::max(most.b, d.b)};
    }
    return most;
}

/// What a link is wrong by, as radiosity of its receiver times the root of its area [W/m].
struct LinkError {
    double of_receiver;  ///< that smaller receivers would mend
    double of_source;    ///< that smaller sources would mend
};

/// Equations (8.26) and (8.28). The form factor changes over a node by its size over the distance, or all at once where
/// a part of it is hidden: over the receiver, it is wrong by that; and over a source whose parts differ, light is.
LinkError error_of(const RadiosityLink& link, const Quadtrees& trees, const Radiosities& B, int rays) {
    const auto [a, b]  = std::pair{link.receiver, link.source};
    const double     F = double(link.form_factor), v = link.visible();
    const Patch &    p = trees[a].shape, &q = trees[b].shape;
    const double     distance = length(p.centre() - q.centre()), root = std::sqrt(p.area());
    const auto       change = [&](const Patch& of) { return std::min(1.0, std::sqrt(of.area()) / distance); };
    const double     unknown = v == 0 ? 1.0 / rays : std::sqrt(v * (1 - v));
    const auto       rho     = trees.polygon_of(a).reflectance;
    const double     light   = largest(rho * B[b]) * F * root;
    constexpr double gradient =
        0.3;  // root mean square of a change of 1 along the side of a square: 1/sqrt(12)
    return {light * (gradient * v * change(p) + unknown),
            largest(rho * spread(trees, B, b)) * F * root * (v * change(q) + unknown) +
                light * unknown / std::sqrt(double(rays))};
}

std::vector<LinkEnd> ends_by_error(const Quadtrees& trees, const std::vector<RadiosityLink>& links,
                                   const Radiosities& B, int rays, double bound) {
    std::vector<LinkError> errors;
    std::vector<double>    sum(trees.size()), count(trees.size());
    for (const auto& link : links) {
        errors.push_back(error_of(link, trees, B, rays));
        sum[link.receiver] += errors.back().of_receiver;
        ++count[link.receiver];
    }
    // sources are many, and their errors have one sign: of a bright wall, the part near what it lights is the brightest
    constexpr double     share_of_a_source = 0.0625;
    std::vector<LinkEnd> ends(links.size(), LinkEnd::none);
    for (std::size_t i = 0; i < links.size(); ++i) {
        const auto [a, b]     = std::pair{links[i].receiver, links[i].source};
        const auto [here, at] = std::pair{errors[i].of_receiver, errors[i].of_source};
        // errors of one receiver add up: what it sees of all its sources ends at the same edge
        const bool cut_a = sum[a] > bound && here * count[a] > 0.5 * sum[a];
        const bool cut_b = at > share_of_a_source * bound;
        if (cut_a && (!cut_b || trees[a].shape.area() >= trees[b].shape.area()))
            ends[i] = LinkEnd::receiver;
        else if (cut_b)
            ends[i] = LinkEnd::source;
    }
    return ends;
}

std::vector<LinkEnd> ends_by_power(const Quadtrees& trees, const std::vector<RadiosityLink>& links,
                                   const Radiosities& B, int rays, double bound) {
    std::vector<LinkEnd> ends(links.size(), LinkEnd::none);
    for (std::size_t i = 0; i < links.size(); ++i) {
        const auto [a, b] = std::pair{links[i].receiver, links[i].source};
        const double F = double(links[i].form_factor), v = links[i].visible();
        const double area = trees[a].shape.area(), visible = std::max(v, 1.0 / rays);
        const double power = largest(trees.polygon_of(a).reflectance * B[b]) * F * visible * area;
        if (power > bound) ends[i] = area >= trees[b].shape.area() ? LinkEnd::receiver : LinkEnd::source;
    }
    return ends;
}

}  // namespace

std::vector<LinkEnd> ends_to_cut(LinkOracle oracle, const Quadtrees& trees,
                                 const std::vector<RadiosityLink>& links, const Radiosities& radiosities,
                                 int rays, double bound) {
    return oracle == LinkOracle::power ? ends_by_power(trees, links, radiosities, rays, bound)
                                       : ends_by_error(trees, links, radiosities, rays, bound);
}

}  // namespace sr
