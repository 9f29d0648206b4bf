#pragma once
/// @file hierarchy_set.hpp
/// What the builder of a hierarchy moves about in the triangles' place.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <glm/gtc/type_ptr.hpp>
#include <utility>
#include <vector>

#include "geometry/box.hpp"

namespace sr {

/// A triangle's box and its centre, and which triangle it is.
template <std::floating_point T>
struct BoxReference {
    Box<T>        box;
    Vector3<T>    middle;
    std::uint32_t triangle;

    BoxReference(const Box<T>& around, std::uint32_t which)
        : box(around), middle(around.min / T{2} + around.max / T{2}), triangle(which) {
        // A box without a corner has no centre, and no order could hold NaN.
        for (int axis = 0; axis < 3; ++axis)
            if (std::isnan(middle[axis])) middle[axis] = 0;
    }

    [[nodiscard]] T centre(int axis) const { return glm::value_ptr(middle)[axis]; }
};

/// Orders references along an axis; of equal centres, the lower triangle comes first.
template <std::floating_point T>
[[nodiscard]] bool comes_before(const BoxReference<T>& a, const BoxReference<T>& b, int axis) {
    const T x = a.centre(axis), y = b.centre(axis);
    return x != y ? x < y : a.triangle < b.triangle;
}

/// A range of references, the box around them and the box around their boxes' centres.
template <std::floating_point T>
struct BoxSet {
    std::uint32_t begin, end;
    Box<T>        box{}, centres{};

    [[nodiscard]] std::uint32_t count() const { return end - begin; }

    void include(const BoxReference<T>& reference) {
        box.include(reference.box);
        centres.include(reference.middle);
    }
    [[nodiscard]] int longest_axis() const {
        const Vector3<T> s = centres.size();
        return s.x >= s.y && s.x >= s.z ? 0 : s.y >= s.z ? 1 : 2;
    }
};

/// References in one order, in which those of a set are neighbours.
template <std::floating_point T>
class ReferenceList {
public:
    explicit ReferenceList(std::vector<BoxReference<T>> references) : references_(std::move(references)) {}

    [[nodiscard]] std::uint32_t size() const { return std::uint32_t(references_.size()); }
    [[nodiscard]] std::uint32_t triangle(std::uint32_t position) const {
        return references_[position].triangle;
    }
    [[nodiscard]] BoxSet<T> set(std::uint32_t begin, std::uint32_t end) const {
        BoxSet<T> result{begin, end};
        for (std::uint32_t i = begin; i < end; ++i) result.include(references_[i]);
        return result;
    }

    /// Puts the lower half along the longest axis of the centres first. @return where the other half begins
    std::uint32_t halve(const BoxSet<T>& set) {
        const int           axis   = set.longest_axis();
        const std::uint32_t middle = set.begin + set.count() / 2;
        std::nth_element(references_.begin() + set.begin, references_.begin() + middle,
                         references_.begin() + set.end,
                         [&](const auto& a, const auto& b) { return comes_before(a, b, axis); });
        return middle;
    }

protected:
    std::vector<BoxReference<T>> references_;
};

}  // namespace sr
