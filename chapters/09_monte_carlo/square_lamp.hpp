#pragma once
/// @file square_lamp.hpp

#include <cmath>
#include <vector>

#include "math/vector.hpp"
#include "radiometry/projected_solid_angle.hpp"
#include "sampling/hemisphere.hpp"
#include "sampling/pdf.hpp"
#include "sampling/spherical_rectangle.hpp"
#include "two_densities.hpp"

namespace sr {

/// The irradiance of a square of side 2 and radiance 1 at the height 1/2, parallel to the receiver, which lies below
/// the middle of one of its edges. Each way is one estimate of it.
class SquareLamp {
public:
    [[nodiscard]] static double exact() {
        const std::vector<Vector3<double>> corners{
            {low, height}, {high.x, low.y, height}, {high, height}, {low.x, high.y, height}};
        return projected_solid_angle(corners).value();
    }

    [[nodiscard]] double by_uniform(Vector2<double> u) const {
        const auto w = sample_uniform_hemisphere(u);
        return hits(w) ? w.z / pdf_uniform_hemisphere(w).value : 0;
    }
    [[nodiscard]] double by_cosine(Vector2<double> u) const {
        const auto w = sample_cosine_hemisphere(u);
        return hits(w) ? w.z / pdf_cosine_hemisphere(w).value : 0;
    }
    [[nodiscard]] double by_area(Vector2<double> u) const {
        const auto w = towards_point(u);
        return w.z / pdf_area(w);
    }
    [[nodiscard]] double by_solid_angle(Vector2<double> u) const {
        const auto p = seen_.sample(u);
        return p.z / length(p) * seen_.solid_angle();
    }
    /// One sample by area and one by the cosine, by the balance heuristic: what is divided by is the sum.
    [[nodiscard]] double by_both(Vector2<double> u, Vector2<double> v) const {
        const auto   a = towards_point(u), c = sample_cosine_hemisphere(v);
        const double by_a = a.z / (pdf_area(a) + pdf_cosine_hemisphere(a).value);
        return hits(c) ? by_a + c.z / (pdf_area(c) + pdf_cosine_hemisphere(c).value) : by_a;
    }

private:
    static constexpr Vector2<double> low{-1, 0}, high{1, 2};
    static constexpr double          height = 0.5;

    [[nodiscard]] static Vector3<double> towards_point(Vector2<double> u) {
        return normalize(Vector3<double>{low + (high - low) * u, height});
    }
    [[nodiscard]] static bool hits(const Vector3<double>& w) {
        const double x = w.x * height / w.z, y = w.y * height / w.z;
        return x >= low.x && x <= high.x && y >= low.y && y <= high.y;
    }
    /// Of a direction to the lamp [1/sr], 1/4 per area.
    [[nodiscard]] static double pdf_area(const Vector3<double>& w) {
        return to_solid_angle({0.25}, square(height / w.z), w.z).value;
    }

    SphericalRectangle<double> seen_{low, high, height};
};

}  // namespace sr
