#pragma once
/// @file patch.hpp

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "geometry/offset.hpp"
#include "math/vector.hpp"

namespace sr {

/// A flat piece of surface that one radiosity is computed for: a triangle or a convex quadrilateral. Its front, which
/// is all that shines, is where its corners run counter-clockwise.
class Patch {
public:
    using Point = Vector3<double>;

    /// @throws std::invalid_argument with the corners, if they have no area
    Patch(const Point& a, const Point& b, const Point& c);
    /// @throws std::invalid_argument with the corners, if they have no area, or do not make_a_quadrilateral
    Patch(const Point& a, const Point& b, const Point& c, const Point& d);

    [[nodiscard]] std::span<const Point> corners() const& { return {corners_.data(), count_}; }
    void                                 corners() const&& = delete;         ///< they would be gone
    [[nodiscard]] double                 area() const { return area_; }      ///< [length unit^2]
    [[nodiscard]] const Vector3<double>& normal() const { return normal_; }  ///< unit vector to the front
    [[nodiscard]] const Point&           centre() const { return centre_; }  ///< of gravity
    [[nodiscard]] double                 longest_side() const;               ///< [length unit]

    /// The point (1-s)(1-t) a + s(1-t) b + st c + (1-s)t d. Of a triangle, the whole side t = 1 is c.
    [[nodiscard]] Point at(Vector2<double> st) const;

    /// The same with s and t moved such that u uniform in the unit square is uniform in the patch's area, and
    /// strata stay in one piece.
    [[nodiscard]] Point sample(Vector2<double> u) const;

    /// A point of the patch for rays to start from or to end at.
    [[nodiscard]] SurfacePoint<double> surface_point(const Point& on_patch) const {
        return {on_patch, normal_, error_};
    }

    /// Four patches that make up this one: by the middles of its sides, of quadrilaterals also the corners' mean.
    [[nodiscard]] std::array<Patch, 4> quarters() const;

    /// What of this patch lies before the surface of another one, by more than rounding: itself, or where that
    /// surface cuts it, one patch or two; none if all lies behind.
    [[nodiscard]] std::vector<Patch> parts_before(const Patch& other) const;

    /// The same from behind.
    [[nodiscard]] Patch reversed() const;

private:
    Patch(const std::array<Point, 4>& corners, std::size_t count);  ///< unchecked

    std::array<Point, 4>  corners_;
    std::size_t           count_;
    double                area_, error_;
    std::array<double, 4> stretch_;  ///< area for each ds dt of at(), at the corners
    Vector3<double>       normal_;
    Point                 centre_;
};

/// Whether four points are corners of a patch: in one plane, up to the six digits that files are rounded to, and none
/// of them turned inwards by more than rounding.
[[nodiscard]] bool make_a_quadrilateral(const std::array<Patch::Point, 4>& corners);

}  // namespace sr
