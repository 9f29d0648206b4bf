#pragma once
/// @file lamps.hpp
/// The two lamps of section 5.8, of radiance 1, and one estimate each of the irradiance that they give, from a point of
/// the unit square. The receiver lies in the origin with normal +z.

#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/disk.hpp"
#include "math/square.hpp"
#include "radiometry/projected_solid_angle.hpp"
#include "radiometry/solid_angle.hpp"
#include "sampling/disk.hpp"
#include "sampling/spherical_rectangle.hpp"

namespace sr {

/// cos cos' / r^2 / pdf of a point of a level lamp, equation (5.21): what a point drawn with this density counts.
[[nodiscard]] inline double area_estimate(const Vector3<double>& p, Pdf<measure::Area> pdf) {
    const double r = length(p), cosine = p.z / r;
    return cosine * solid_angle_per_area(cosine, Length<double>{r}).value() / pdf.value;
}

/// A unit disk at the height 1, parallel to the receiver, whose centre is so far aside.
class DiskLamp {
public:
    explicit DiskLamp(double aside) : aside_{aside}, around_{{aside - 1, -1}, {aside + 1, 1}, 1} {}

    [[nodiscard]] double exact() const {
        return projected_solid_angle(Disk<double>{{aside_, 0, 1}, {0, 0, -1}, 1}).value();
    }
    [[nodiscard]] double by_area(Vector2<double> u) const {
        const auto p = sample_disk(u, 1.0);
        return area_estimate({aside_ + p.x, p.y, 1}, pdf_disk(p, 1.0));
    }
    /// Of the square around the disk: what misses the disk counts nothing.
    [[nodiscard]] double by_solid_angle(Vector2<double> u) const {
        const auto p = around_.sample(u);
        return square(p.x - aside_) + square(p.y) <= 1 ? p.z / length(p) / around_.pdf(p).value : 0;
    }

private:
    double                     aside_;
    SphericalRectangle<double> around_;
};

/// A square of side 2 at the height 2, and halfway below its middle a disk of radius 0.3 that hides a part of it.
class OccludedSquare {
public:
    /// @param receiver  where it is, seen from below the middle; at most 0.4 away, so that all of the disk is before
    ///                  the lamp
    explicit OccludedSquare(Vector2<double> receiver)
        : middle_{-receiver}, seen_{middle_ - 1.0, middle_ + 1.0, 2} {}

    /// The lamp's, less that of the part hidden: a disk of twice the radius in its plane.
    [[nodiscard]] double exact() const {
        const Vector2<double>              low = middle_ - 1.0, high = middle_ + 1.0;
        const std::vector<Vector3<double>> lamp{{low, 2}, {high.x, low.y, 2}, {high, 2}, {low.x, high.y, 2}};
        const Disk<double>                 hidden{{2.0 * middle_, 2}, {0, 0, -1}, 0.6};
        return (projected_solid_angle(lamp) - projected_solid_angle(hidden)).value();
    }
    [[nodiscard]] double by_area(Vector2<double> u) const {
        const Vector3<double> p{middle_ - 1.0 + 2.0 * u, 2};
        return visible(p) ? area_estimate(p, {0.25}) : 0;
    }
    [[nodiscard]] double by_solid_angle(Vector2<double> u) const {
        const auto p = seen_.sample(u);
        return visible(p) ? p.z / length(p) / seen_.pdf(p).value : 0;
    }

private:
    /// Whether the line of sight to a point of the lamp passes by the disk, which it meets halfway.
    [[nodiscard]] bool visible(const Vector3<double>& p) const {
        const Vector2<double> beside = Vector2<double>(p) / 2.0 - middle_;
        return dot(beside, beside) > square(0.3);
    }

    Vector2<double>            middle_;
    SphericalRectangle<double> seen_;
};

/// Receivers on a spiral around the middle, as far as `radius`.
[[nodiscard]] inline std::vector<OccludedSquare> receivers_below_a_square(int count, double radius) {
    std::vector<OccludedSquare> all;
    for (int i = 0; i < count; ++i) {
        const double r = radius * std::sqrt((i + 0.5) / count), phi = 2.4 * i;
        all.emplace_back(r * Vector2<double>{std::cos(phi), std::sin(phi)});
    }
    return all;
}

/// Receivers from under the disk's middle to beyond its rim.
[[nodiscard]] inline std::vector<DiskLamp> receivers_below_a_disk(int count, double farthest) {
    std::vector<DiskLamp> all;
    for (int i = 0; i < count; ++i) all.emplace_back(farthest * (i + 0.5) / count);
    return all;
}

}  // namespace sr
