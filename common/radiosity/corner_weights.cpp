/// @file corner_weights.cpp

#include "radiosity/corner_weights.hpp"

#include <cmath>

namespace sr {
namespace {

/// The s and t with patch.at({s, t}) = a + s e + t f + st g. The point without t f is a multiple of e + t g: that is a
/// quadratic equation for t, which rises through its root in the patch.
Vector2<double> bilinear(const Patch& patch, const Patch::Point& point) {
    const auto            p = patch.corners();
    const Vector3<double> e = p[1] - p[0], f = p[3] - p[0], g = p[2] - p[3] - e, h = point - p[0];
    const auto            area = [&](const Vector3<double>& u, const Vector3<double>& v) {
        return dot(patch.normal(), cross(u, v));
    };
    const double          A = area(g, f), B = area(h, g) + area(e, f), C = area(h, e);
    const double          discriminant = B * B - 4 * A * C;
    const double          root         = discriminant < 0 ? 0 : std::sqrt(discriminant);
    // of the two forms of the root the one that adds numbers of one sign
    const double          t     = B > 0 ? -2 * C / (B + root) : (root - B) / (2 * A);
    const Vector3<double> along = e + t * g;
    return {dot(h - t * f, along) / dot(along, along), t};
}

}  // namespace

std::array<double, 4> corner_weights(const Patch& patch, const Patch::Point& point) {
    const auto p = patch.corners();
    if (p.size() == 3) {
        const double twice = 2 * patch.area();
        const double b     = dot(patch.normal(), cross(point - p[0], p[2] - p[0])) / twice;
        const double c     = dot(patch.normal(), cross(p[1] - p[0], point - p[0])) / twice;
        return {1 - b - c, b, c, 0};
    }
    const auto   st = bilinear(patch, point);
    const double s = st.x, t = st.y;
    return {(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t};
}

}  // namespace sr
