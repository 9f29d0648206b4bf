#pragma once
/// @file bsdf_laws.hpp
/// The laws of scattering, and of drawing directions, that any BSDF is put through. Each returns what breaks it, or
/// nothing, so that a test can ask for either:
///     CHECK(breaks_reciprocity(Phong{20.0}) == "");
///     CHECK(breaks_energy(Phong{1.0, PhongScale::none}) != "");
/// For lobes above an opaque surface. Deltas have neither f nor pdf: their laws are about weights, in delta_laws.hpp.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "material/bsdf.hpp"
#include "math/degrees.hpp"
#include "math/extremes.hpp"
#include "math/gauss_legendre.hpp"
#include "math/vector.hpp"
#include "radiometry/spectrum.hpp"
#include "sampling/ball.hpp"
#include "sampling/hemisphere.hpp"
#include "sampling/hemisphere_rule.hpp"
#include "sampling/rng.hpp"
#include "statistics/running.hpp"
#include "statistics/tests.hpp"

namespace sr::test {

using Direction = Vector3<double>;

/// The unit vector at these angles [degrees] to the normal, and about it.
[[nodiscard]] inline Direction at_angle(double theta, double phi = 0) {
    const double s = std::sin(radians(theta));
    return {s * std::cos(radians(phi)), s * std::sin(radians(phi)), std::cos(radians(theta))};
}

/// From where the laws look: straight, at a slant, and nearly along the surface.
[[nodiscard]] inline std::vector<Direction> views() {
    return {at_angle(0), at_angle(20, 100), at_angle(50, -35), at_angle(75, 10), at_angle(89, 200)};
}

inline double number(double value) {
    return value;
}
inline double number(Spectrum value) {
    return double(value.g);
}

[[nodiscard]] inline std::string broken(const char* law, const Direction& wo, double got, double expected) {
    return fmt::format("{}: {} in place of {} where wo = ({}, {}, {})", law, got, expected, wo.x, wo.y, wo.z);
}

/// Tries a law on random pairs of directions of the whole sphere.
template <class Law>
[[nodiscard]] std::string for_pairs(const Law& law) {
    Rng rng{61, 0, 0, 0};
    for (int i = 0; i < 20'000; ++i) {
        const auto  wo = normalize(in_unit_ball<double>(rng)), wi = normalize(in_unit_ball<double>(rng));
        std::string what = law(wo, wi);
        if (!what.empty()) return what;
    }
    return "";
}

/// f and pdf are finite and not negative, and 0 where a direction lies below the horizon.
template <class B>
[[nodiscard]] std::string breaks_positivity(const B& bsdf) {
    return for_pairs([&](const Direction& wo, const Direction& wi) -> std::string {
        const double f = number(bsdf.f(wo, wi)), p = bsdf.pdf(wo, wi).value;
        if (!(f >= 0 && std::isfinite(f))) return broken("positive f", wo, f, 0);
        if (!(p >= 0 && std::isfinite(p))) return broken("positive pdf", wo, p, 0);
        const bool above = wo.z > 0 && wi.z > 0;
        if (!above && !(f == 0 && p == 0)) return broken("opaque surface", wo, f + p, 0);
        return "";
    });
}

/// Helmholtz: f(wo, wi) = f(wi, wo), to 10^-12 of it.
template <class B>
[[nodiscard]] std::string breaks_reciprocity(const B& bsdf) {
    return for_pairs([&](const Direction& wo, const Direction& wi) -> std::string {
        const double there = number(bsdf.f(wo, wi)), back = number(bsdf.f(wi, wo));
        if (std::abs(there - back) <= 1e-12 * max_or_nan(std::abs(there), std::abs(back))) return "";
        return broken("reciprocity", wo, there, back);
    });
}

/// The share of the light from wo that is given back, by quadrature of f cos.
template <class B>
[[nodiscard]] double albedo(const B& bsdf, const Direction& wo, int n = 96) {
    double sum = 0;
    for (const auto& [wi, weight] : hemisphere_rule(n)) sum += weight * number(bsdf.f(wo, wi)) * wi.z;
    return sum;
}

/// The light that a sky sends on to wo, and its error, by sampling.
/// @param sky  (wi) -> radiance
template <class B, class Sky>
[[nodiscard]] Running sampled_light(const B& bsdf, const Direction& wo, const Sky& sky) {
    Rng     rng{62, 0, 0, 0};
    Running light;
    for (int i = 0; i < 50'000; ++i) {
        const double u = rng.uniform<double>(), v = rng.uniform<double>();
        const auto   one = bsdf.sample(wo, {u, v}, TransportMode::radiance);
        light.add(one ? number(one->weight) * sky(one->wi) : 0);
    }
    return light;
}

/// No more light is given back than arrives, and sampling finds as much of it as quadrature.
template <class B>
[[nodiscard]] std::string breaks_energy(const B& bsdf) {
    for (const Direction& wo : views()) {
        const double by_quadrature = albedo(bsdf, wo);
        if (!(by_quadrature <= 1 + 1e-6)) return broken("energy", wo, by_quadrature, 1);
        const Running by_sampling = sampled_light(bsdf, wo, [](const Direction&) { return 1.0; });
        const double  error =
            5 * by_sampling.standard_error() + 1e-5;  // the rule's own, where a lobe has a kink
        if (!(std::abs(by_sampling.mean() - by_quadrature) <= error))
            return broken("energy by sampling", wo, by_sampling.mean(), by_quadrature);
    }
    return "";
}

/// A lobe's f as a sum counts it: a delta has none.
template <class B>
[[nodiscard]] double f_in_sum(const B& lobe, const Direction& wo, const Direction& wi) {
    if constexpr (requires { lobe.f(wo, wi); })
        return number(lobe.f(wo, wi));
    else
        return 0;
}

/// What a sum of two lobes scatters is what each of them does, in f, to 10^-6 of it, and of a sky that is brighter on
/// one side, by sampling.
template <class Sum, class First, class Second>
[[nodiscard]] std::string breaks_linearity(const Sum& sum, double a, const First& first, double b,
                                           const Second& second) {
    constexpr double float_underflow = 1e-37;  // a sum counts in float
    std::string      of_f = for_pairs([&](const Direction& wo, const Direction& wi) -> std::string {
        const double of_sum = number(sum.f(wo, wi));
        const double sum_of = a * f_in_sum(first, wo, wi) + b * f_in_sum(second, wo, wi);
        return std::abs(of_sum - sum_of) <= 1e-6 * sum_of + float_underflow
                        ? ""
                        : broken("linear f", wo, of_sum, sum_of);
    });
    if (!of_f.empty()) return of_f;
    const auto sky = [](const Direction& wi) { return 1.5 + wi.x; };
    for (const Direction& wo : views()) {
        const Running whole = sampled_light(sum, wo, sky), one = sampled_light(first, wo, sky),
                      two   = sampled_light(second, wo, sky);
        const double sum_of = a * one.mean() + b * two.mean();
        const double error =
            5 * (whole.standard_error() + a * one.standard_error() + b * two.standard_error()) + 1e-6;
        if (!(std::abs(whole.mean() - sum_of) <= error))
            return broken("linearity by sampling", wo, whole.mean(), sum_of);
    }
    return "";
}

/// The pdf integrates to 1, less the share of draws that come to nothing.
template <class B>
[[nodiscard]] std::string breaks_normalisation(const B& bsdf) {
    for (const Direction& wo : views()) {
        double sum = 0;
        for (const auto& [wi, weight] : hemisphere_rule(96)) sum += weight * bsdf.pdf(wo, wi).value;
        Rng           rng{63, 0, 0, 0};
        constexpr int draws = 50'000;
        int           drawn = 0;
        for (int i = 0; i < draws; ++i) {
            const double u = rng.uniform<double>(), v = rng.uniform<double>();
            drawn += bsdf.sample(wo, {u, v}, TransportMode::radiance) ? 1 : 0;
        }
        const double share = double(drawn) / draws;
        if (!(std::abs(sum - share) <= 5 * std::sqrt(share * (1 - share) / draws) + 1e-5))
            return broken("integral of the pdf", wo, sum, share);
    }
    return "";
}

/// Cells of equal solid angle: bands of height, cut by azimuth.
struct Cells {
    static constexpr int bands = 12, sectors = 24;

    [[nodiscard]] static std::size_t of(const Direction& w) {
        const auto band   = std::size_t(std::min(int(w.z * bands), bands - 1));
        const auto sector = std::size_t(std::min(int(turn(w) * sectors), sectors - 1));
        return band * sectors + sector;
    }

    /// The integral of a density over each; what is left of 1, draws that come to nothing; and 0 below the horizon.
    template <class Density>
    [[nodiscard]] static std::vector<double> probabilities(const Density& density) {
        std::vector<double> cells;
        double              left = 1;
        for (int cell = 0; cell < bands * sectors; ++cell) {
            const int    band = cell / sectors, sector = cell % sectors;
            const double z = band, phi = sector, step = 2 * std::numbers::pi / sectors;
            double       sum = 1e-8;  // not impossible: a density's edge may pass between the points
            for (const auto& [height, dz] : gauss_legendre(16, z / bands, (z + 1) / bands)) {
                const double r = std::sqrt((1 - height) * (1 + height));
                for (const auto& [angle, dphi] : gauss_legendre(16, phi * step, (phi + 1) * step))
                    sum += dz * dphi * density(Direction{r * std::cos(angle), r * std::sin(angle), height});
            }
            cells.push_back(sum);
            left -= sum;
        }
        cells.push_back(left > 0 ? left : 0);
        cells.push_back(0);
        return cells;
    }
};

/// How likely it is that these draws come from that density: p of a chi-square test, the least of all views.
template <class Sampled, class Stated>
[[nodiscard]] double chance_of_density(const Sampled& sampled, const Stated& stated) {
    constexpr int draws = 100'000;
    double        least = 1;
    for (const Direction& wo : views()) {
        auto expected = Cells::probabilities([&](const Direction& wi) { return stated.pdf(wo, wi).value; });
        for (double& cell : expected) cell *= draws;
        std::vector<std::uint64_t> observed(expected.size());
        Rng                        rng{64, 0, 0, 0};
        for (int i = 0; i < draws; ++i) {
            const double u = rng.uniform<double>(), v = rng.uniform<double>();
            const auto   one = sampled.sample(wo, {u, v}, TransportMode::radiance);
            ++observed[!one ? expected.size() - 2 : one->wi.z > 0 ? Cells::of(one->wi) : expected.size() - 1];
        }
        least = min_or_nan(least, chi_square_test(observed, expected).p);
    }
    return least;
}

/// Directions come with the density that pdf says, at a significance of 0.001.
template <class B>
[[nodiscard]] std::string breaks_density(const B& bsdf) {
    const double p = chance_of_density(bsdf, bsdf);
    return p > 0.001 ? "" : fmt::format("density: p = {}", p);
}

/// The unit square is stretched by 1 / pdf where it is mapped to directions, by central differences.
template <class B>
[[nodiscard]] std::string breaks_jacobian(const B& bsdf) {
    constexpr double h     = 1e-5;
    int              tried = 0;
    for (const Direction& wo : views()) {
        for (int i = 0; i < 64; ++i) {
            const int             column = i % 8, row = i / 8;
            const Vector2<double> u{(column + 0.5) / 8, (row + 0.5) / 8};
            const auto            at = [&](double du, double dv) {
                return bsdf.sample(wo, {u.x + du, u.y + dv}, TransportMode::radiance);
            };
            const std::array near{at(0, 0), at(h, 0), at(-h, 0), at(0, h), at(0, -h)};
            if (!(near[0] && near[1] && near[2] && near[3] && near[4])) continue;
            ++tried;
            const Direction along_u = near[1]->wi - near[2]->wi, along_v = near[3]->wi - near[4]->wi;
            const double    stretch = length(cross(along_u, along_v)) / (4 * h * h);
            const double    product = stretch * near[0]->pdf.value;
            if (!(std::abs(product - 1) <= 1e-5)) return broken("Jacobian times pdf", wo, product, 1);
            if (!(std::abs(near[0]->pdf.value / bsdf.pdf(wo, near[0]->wi).value - 1) <= 1e-9))
                return broken("pdf of a sample", wo, near[0]->pdf.value, bsdf.pdf(wo, near[0]->wi).value);
        }
    }
    return tried > 100 ? "" : fmt::format("Jacobian: only {} draws came to something", tried);
}

/// The laws of one lobe that it breaks, by name, each with a blank behind it. Not the Jacobian: a sum of lobes has
/// none, for its number chooses first.
template <class B>
[[nodiscard]] std::string broken_laws(const B& bsdf) {
    std::string names;
    const auto  ask = [&](const char* name, const std::string& what) { names += what.empty() ? "" : name; };
    ask("positivity ", breaks_positivity(bsdf));
    ask("reciprocity ", breaks_reciprocity(bsdf));
    ask("energy ", breaks_energy(bsdf));
    const std::string normalisation = breaks_normalisation(bsdf);
    ask("normalisation ", normalisation);
    if (normalisation.empty())
        ask("density ", breaks_density(bsdf));  // there is nothing to compare otherwise
    return names;
}

}  // namespace sr::test
