/// @file hierarchical_radiosity.cpp

#include "radiosity/hierarchical_radiosity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "radiosity/exchange_area.hpp"
#include "radiosity/rows.hpp"
#include "radiosity/visible_share.hpp"

namespace sr {
namespace {

/// The nodes of a link that is still to be computed.
struct Pair {
    std::uint32_t receiver, source;
};

void check(std::span<const Polygon> polygons, const HierarchicalSettings& settings) {
    const auto refuse = [](const char* what, double value, const char* right) {
        throw std::invalid_argument(
            fmt::format("hierarchical radiosity: {} is {}; must be {}", what, value, right));
    };
    if (!(settings.bound > 0)) refuse("the bound", settings.bound, "above 0");
    if (!(settings.smallest >= 0)) refuse("the smallest area", settings.smallest, "0 or more");
    if (!(settings.tolerance > 0)) refuse("the tolerance", settings.tolerance, "above 0");
    if (settings.strata < 2 || settings.strata % 2 != 0)
        refuse("the number of strata", settings.strata, "even and above 0");
    const auto refuse_colour = [](std::size_t i, const char* what, DoubleSpectrum s, const char* right) {
        throw std::invalid_argument(
            fmt::format("polygon {}: its {} is ({}, {}, {}); must be {}", i, what, s.r, s.g, s.b, right));
    };
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        const auto& [shape, reflectance, emission, material] = polygons[i];
        if (!each_in(reflectance, 0, 1)) refuse_colour(i, "reflectance", reflectance, "from 0 to 1");
        if (!each_in(emission, 0, std::numeric_limits<double>::max()))
            refuse_colour(i, "emission", emission, "finite, and 0 or more");
    }
}

/// A solution in the making.
class Refinement {
public:
    Refinement(std::span<const Polygon> polygons, const Visibility& visibility,
               const HierarchicalSettings& settings)
        : settings_{settings}, visibility_{visibility}, solution_{Quadtrees(polygons), {}, {}} {
        std::vector<Pair> pairs;
        for (std::uint32_t a = 0; a < polygons.size(); ++a)
            for (std::uint32_t b = 0; b < polygons.size(); ++b)
                if (a != b) pairs.push_back({a, b});
        for (const auto& polygon : polygons) solution_.radiosities.push_back(polygon.emission);
        add_links(pairs);
        solve();
    }

    /// Cuts the nodes of links until the oracle is content with all of them.
    void refine(double bound) {
        for (auto pairs = replaced_links(bound); !pairs.empty(); pairs = replaced_links(bound))
            add_links(pairs);
    }

    /// Jacobi's iteration from the radiosities that there are. A new node begins with its parent's. No step moves
    /// more than q times as much light as the one before, q the largest reflectance: q + q^2 + ... times the last
    /// one's is to come.
    void solve() {
        constexpr int limit  = 20'000;
        const double  q      = std::min(0.99, largest_reflectance());
        double        before = 0;
        for (int step = 0; step < limit; ++step) {
            auto   next  = solution_.trees.push_pull(gathered());
            double moved = 0, reflected = 0;  // the primary counts that has most [W]
            for (std::size_t i = 0; i < next.size(); ++i) {
                if (!solution_.trees[i].is_leaf()) continue;
                const double area = solution_.trees[i].shape.area();
                moved += area * largest(magnitude(next[i] - solution_.radiosities[i]));
                reflected += area * largest(next[i] - solution_.trees.polygon_of(i).emission);
            }
            solution_.radiosities = std::move(next);
            const bool shrinks    = moved < 0.995 * before;
            if (moved == 0 || (shrinks && moved * q / (1 - q) <= settings_.tolerance * reflected)) return;
            before = moved;
        }
        throw std::runtime_error(fmt::format(
            "hierarchical radiosity: no solution after {} steps; light hardly gets out of a closed scene "
            "whose polygons reflect 0.99 and more of it, as {} do",
            limit, white_polygons()));
    }

    /// Links that were kept because smaller nodes might see each other carry nothing.
    [[nodiscard]] HierarchicalSolution take() {
        std::erase_if(solution_.links, [](const RadiosityLink& link) { return link.visible() == 0; });
        solution_.links.shrink_to_fit();
        return std::move(solution_);
    }

private:
    [[nodiscard]] double largest_reflectance() const {
        double rho = 0;
        for (std::size_t i = 0; i < solution_.trees.polygon_count(); ++i)
            rho = std::max(rho, largest(solution_.trees.polygon_of(i).reflectance));
        return rho;
    }

    /// Which reflect all light of some primary, or so much that form factors would have to be exact.
    [[nodiscard]] std::string white_polygons() const {
        std::vector<std::size_t> white;
        for (std::size_t i = 0; i < solution_.trees.polygon_count(); ++i)
            if (largest(solution_.trees.polygon_of(i).reflectance) >= 0.99) white.push_back(i);
        return fmt::format("{}", fmt::join(white, ", "));
    }

    /// Removes the links that are too coarse. @return those that take their place
    [[nodiscard]] std::vector<Pair> replaced_links(double bound) {
        auto& [trees, links, radiosities] = solution_;
        const auto        ends            = ends_to_cut(settings_.oracle, trees, links, radiosities,
                                                        settings_.strata * settings_.strata, bound);
        std::vector<Pair> pairs;
        std::size_t       kept = 0;
        for (std::size_t i = 0; i < links.size(); ++i) {
            const auto [a, b]       = std::pair{links[i].receiver, links[i].source};
            const std::uint32_t cut = ends[i] == LinkEnd::receiver ? a : b;
            if (ends[i] == LinkEnd::none || !(trees[cut].shape.area() >= 4 * settings_.smallest)) {
                links[kept++] = links[i];
                continue;
            }
            const std::uint32_t first = trees.children(cut);
            radiosities.resize(trees.size(), radiosities[cut]);
            for (std::uint32_t child = first; child < first + 4; ++child)
                pairs.push_back(cut == a ? Pair{child, b} : Pair{a, child});
        }
        links.resize(kept);
        return pairs;
    }

    void add_links(const std::vector<Pair>& pairs) {
        std::vector<RadiosityLink> more(pairs.size());
        constexpr std::size_t      block = 256;
        for_each_row((pairs.size() + block - 1) / block, {.threads = settings_.threads},
                     [&](std::size_t row) {
                         const std::size_t first = row * block, end = std::min(pairs.size(), first + block);
                         for (std::size_t i = first; i < end; ++i) more[i] = link(pairs[i]);
                         if (settings_.on_links) settings_.on_links(int(end - first));
                     });
        for (const auto& each : more)
            if (each.form_factor > 0) solution_.links.push_back(each);
    }

    [[nodiscard]] RadiosityLink link(const Pair& pair) const {
        const Patch & p = solution_.trees[pair.receiver].shape, &q = solution_.trees[pair.source].shape;
        const double  exchange = exchange_area(p, q);
        Rng           rng{settings_.seed, pair.receiver, pair.source, 0};
        RadiosityLink link{pair.receiver, pair.source, float(exchange / p.area()), {}};
        if (exchange > 0) {
            const auto seen = visible_quarters(p, q, visibility_, settings_.strata, rng);
            std::transform(seen.begin(), seen.end(), link.seen.begin(), [](double s) { return float(s); });
        }
        return link;
    }

    /// What arrives at each node over its own links: irradiances [W/m^2], equation (8.29).
    [[nodiscard]] Radiosities gathered() const {
        Radiosities irradiances(solution_.trees.size());
        for (const auto& link : solution_.links)
            irradiances[link.receiver] = irradiances[link.receiver] + double(link.form_factor) * seen(link);
        return irradiances;
    }

    /// Of the radiosity of a link's source, what is seen of it.
    [[nodiscard]] DoubleSpectrum seen(const RadiosityLink& link) const {
        const auto& [trees, links, B] = solution_;
        if (trees[link.source].is_leaf()) return link.visible() * B[link.source];
        DoubleSpectrum sum;
        for (std::size_t k = 0; k < 4; ++k)
            sum = sum + double(link.seen[k]) * B[trees[link.source].first_child + k];
        return sum;
    }

    HierarchicalSettings settings_;
    const Visibility&    visibility_;
    HierarchicalSolution solution_;
};

/// In what the oracle's bounds are shares of: W, or W/m.
double unit_of_bound(std::span<const Polygon> polygons, LinkOracle oracle) {
    double         area = 0;
    DoubleSpectrum power;
    for (const auto& polygon : polygons) {
        area += polygon.shape.area();
        power = power + polygon.shape.area() * polygon.emission;
    }
    return oracle == LinkOracle::power ? largest(power) : largest(power) / std::sqrt(area);
}

}  // namespace

std::size_t HierarchicalSolution::bytes() const {
    return trees.bytes() + links.capacity() * sizeof(RadiosityLink) +
           radiosities.capacity() * sizeof(DoubleSpectrum);
}

HierarchicalSolution hierarchical_radiosity(std::span<const Polygon> polygons, const Visibility& visibility,
                                            const HierarchicalSettings& settings) {
    check(polygons, settings);
    const double unit = unit_of_bound(polygons, settings.oracle);
    Refinement   refinement(polygons, visibility, settings);
    for (const int times : {64, 16, 4, 1}) {
        refinement.refine(times * settings.bound * unit);
        refinement.solve();
    }
    return refinement.take();
}

}  // namespace sr
