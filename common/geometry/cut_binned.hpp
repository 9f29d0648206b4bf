#pragma once
/// @file cut_binned.hpp

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <optional>

#include "geometry/hierarchy_cost.hpp"
#include "geometry/hierarchy_set.hpp"

namespace sr {

/// Cuts where the expected cost is least, of 15 places along each axis: triangles are counted in 16 bins
/// instead of being sorted.
/// @see Wald, On fast Construction of SAH-based Bounding Volume Hierarchies, 2007
template <std::floating_point T>
class BinnedCut : public ReferenceList<T> {
public:
    using ReferenceList<T>::ReferenceList;

    /// As MedianCut::cut.
    std::optional<std::uint32_t> cut(const BoxSet<T>& set) {
        const auto best = cheapest(set);
        if (is_best_as_leaf(set, best ? std::optional(best->cost) : std::nullopt)) return std::nullopt;
        return best ? partition(set, *best) : this->halve(set);
    }

private:
    static constexpr int bin_count = 16;

    struct Place {
        int axis;
        int bin;  ///< the first bin on the far side
        T   cost;
    };

    static int bin_of(const BoxSet<T>& set, const BoxReference<T>& reference, int axis) {
        const T begin    = glm::value_ptr(set.centres.min)[axis];
        const T length   = glm::value_ptr(set.centres.max)[axis] - begin;
        const T position = (reference.centre(axis) - begin) / length * bin_count;
        if (!(position > 0)) return 0;  // NaN, too, of boxes without end
        return position < bin_count ? int(position) : bin_count - 1;
    }

    std::optional<Place> cheapest(const BoxSet<T>& set) const {
        std::optional<Place> best;
        for (int axis = 0; axis < 3; ++axis) {
            if (!(set.centres.size()[axis] > 0)) continue;
            const auto place = cheapest(set, axis);
            if (place && !(best && best->cost <= place->cost)) best = place;
        }
        return best;
    }

    std::optional<Place> cheapest(const BoxSet<T>& set, int axis) const {
        std::array<Box<T>, bin_count>        box;
        std::array<std::uint32_t, bin_count> count{};
        for (std::uint32_t i = set.begin; i < set.end; ++i) {
            const auto bin = std::size_t(bin_of(set, this->references_[i], axis));
            box[bin].include(this->references_[i].box);
            ++count[bin];
        }

        // Once from the near side, to keep the cost of what has been passed, and once from the far side.
        std::array<T, bin_count> near_cost{};
        Box<T>                   passed_box;
        std::uint32_t            passed = 0;
        for (std::size_t bin = 1; bin < bin_count; ++bin) {
            passed_box.include(box[bin - 1]);
            passed += count[bin - 1];
            near_cost[bin] = T(passed) * passed_box.half_area();
        }
        std::optional<Place> best;
        passed_box = {};
        passed     = 0;
        for (std::size_t bin = bin_count - 1; bin > 0; --bin) {
            passed_box.include(box[bin]);
            passed += count[bin];
            if (passed == 0 || passed == set.count()) continue;
            const T cost = cut_cost(set, near_cost[bin], T(passed) * passed_box.half_area());
            if (!(best && best->cost <= cost)) best = Place{axis, int(bin), cost};
        }
        return best;
    }

    std::uint32_t partition(const BoxSet<T>& set, const Place& place) {
        const auto begin  = this->references_.begin();
        const auto middle = std::partition(begin + set.begin, begin + set.end, [&](const auto& r) {
            return bin_of(set, r, place.axis) < place.bin;
        });
        return std::uint32_t(middle - begin);
    }
};

}  // namespace sr
