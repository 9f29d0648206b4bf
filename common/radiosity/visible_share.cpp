/// @file visible_share.cpp

#include "radiosity/visible_share.hpp"

#include "radiosity/point_form_factors.hpp"
#include "radiosity/point_pairs.hpp"

namespace sr {

double visible_share(const Patch& a, const Patch& b, const Visibility& visibility, int side, Rng& rng) {
    double all = 0, seen = 0;
    for (const auto& [p, q] : stratified_pairs(a, b, side, rng)) {
        const double weight = form_factor_kernel(p, a.normal(), q, b.normal());
        all += weight;
        if (weight > 0 && visibility.between(a.surface_point(p), b.surface_point(q))) seen += weight;
    }
    return all > 0 ? seen / all : 1;
}

std::array<double, 4> visible_quarters(const Patch& a, const Patch& b, const Visibility& visibility, int side,
                                       Rng& rng) {
    const auto            quarters = b.quarters();
    double                all      = 0;
    std::array<double, 4> seen{};
    for (std::size_t k = 0; k < 4; ++k) {
        if (!(quarters[k].area() > 0)) continue;  // of a sliver
        for (const auto& [p, q] : stratified_pairs(a, quarters[k], side / 2, rng)) {
            const double weight = quarters[k].area() * form_factor_kernel(p, a.normal(), q, b.normal());
            all += weight;
            if (weight > 0 && visibility.between(a.surface_point(p), b.surface_point(q))) seen[k] += weight;
        }
    }
    for (auto& each : seen) each = all > 0 ? each / all : 0.25;
    return seen;
}

double visible_share(const SurfacePoint<double>& from, const Patch& to, const Visibility& visibility,
                     int side, Rng& rng) {
    double all = 0, seen = 0;
    for (const auto& q : stratified_points(to, side, rng)) {
        const double weight = form_factor_kernel(from.position, from.normal, q, to.normal());
        all += weight;
        if (weight > 0 && visibility.between(from, to.surface_point(q))) seen += weight;
    }
    return all > 0 ? seen / all : 1;
}

double sampled_form_factor(const Patch& from, const Patch& to, const Visibility& visibility, int side,
                           Rng& rng) {
    double sum = 0;
    for (const auto& [p, q] : stratified_pairs(from, to, side, rng)) {
        const double kernel = form_factor_kernel(p, from.normal(), q, to.normal());
        if (kernel > 0 && visibility.between(from.surface_point(p), to.surface_point(q))) sum += kernel;
    }
    return to.area() * sum / (side * side);
}

}  // namespace sr
