#pragma once
/// @file tree_diagram.hpp
/// Figure 7.1: the tree of one pixel's rays, traced in a plane through a glass ball, a mirror, a floor and a light.

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "course/chapter.hpp"
#include "material/fresnel.hpp"
#include "optics.hpp"

namespace sr {

/// A circle's outline on paper.
[[nodiscard]] inline std::vector<course::Point> circle(course::Point centre, double radius,
                                                       int corners = 96) {
    std::vector<course::Point> outline;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * i / corners;
        outline.push_back(centre + radius * course::Point{std::cos(angle), std::sin(angle)});
    }
    return outline;
}

[[nodiscard]] inline course::Point on_paper(const Vector3<double>& p) {
    return {p.x, p.y};
}

/// The recursion of (7.5), which draws each ray that it follows. What counts more is drawn thicker.
class TreeDrawing {
public:
    explicit TreeDrawing(course::Diagram diagram) : diagram_{std::move(diagram)} {}

    void draw() {
        using course::Ink;
        diagram_.polygon(circle(on_paper(ball_.centre), ball_.radius), {Ink::sky}, 0.18);
        diagram_.line({left, floor_.point.y}, {mirror_.point.x, floor_.point.y},
                      {Ink::black, course::Weight::thick});
        diagram_.line({mirror_.point.x, floor_.point.y}, {mirror_.point.x, 2.6},
                      {Ink::blue, course::Weight::thick});
        follow({{left, 0.95, 0}, normalize(Vector3<double>{3.1, -0.42, 0})}, 1, 1, Ink::black);
        diagram_.point(on_paper(light_), {Ink::amber});
        diagram_.label(on_paper(light_) + course::Point{0, 0.22}, "light", course::Anchor::centre,
                       Ink::amber);
        diagram_.label(on_paper(light_) + course::Point{0.12, -0.8}, "shadow ray", course::Anchor::left,
                       Ink::amber);
        diagram_.point({left, 0.95});
        diagram_.label({left, 1.2}, "eye", course::Anchor::centre);
        diagram_.label({-0.25, -1.62}, "paint", course::Anchor::centre);
        diagram_.label({mirror_.point.x - 0.12, 2.35}, "mirror", course::Anchor::right, Ink::blue);
        diagram_.label({0.15, -0.5}, "glass", course::Anchor::centre, Ink::sky);
    }

private:
    using Bent = std::optional<Ray<double>>;

    void follow(const Ray<double>& ray, int depth, double weight, course::Ink ink) {
        if (depth > 6 || weight < 0.01) return;
        const auto in_ball = intersect(ball_, ray);
        const auto at_wall = intersect(mirror_, ray), on_floor = intersect(floor_, ray);
        const auto pen = course::Pen{ink, weight > 0.5    ? course::Weight::thick
                                          : weight > 0.02 ? course::Weight::medium
                                                          : course::Weight::thin};
        if (in_ball) {
            const auto   point = surface_point(ball_, ray, *in_ball);
            const Bent   bent  = refracted(ray, point, n_);
            const double cos_i = std::abs(dot(normalize(ray.direction), point.normal));
            const bool   out   = dot(ray.direction, point.normal) < 0;
            const double R     = fresnel(cos_i, out ? n_ : 1 / n_).mean();
            draw_ray(ray, point, depth, weight, pen);
            follow(reflected(ray, point), depth + 1, weight * R, course::Ink::vermilion);
            if (bent) follow(*bent, depth + 1, weight * (1 - R), course::Ink::green);
        } else if (at_wall && !(on_floor && *on_floor < *at_wall)) {
            const auto point = surface_point(mirror_, ray, *at_wall);
            draw_ray(ray, point, depth, weight, pen);
            follow(reflected(ray, point), depth + 1, weight, course::Ink::vermilion);
        } else if (on_floor && ray.at(*on_floor).x > left) {
            const auto point = surface_point(floor_, ray, *on_floor);
            draw_ray(ray, point, depth, weight, pen);
            if (!intersect(ball_, between(point, light_), before_the_end<double>))
                diagram_.line(on_paper(point.position), on_paper(light_),
                              {course::Ink::amber, course::Weight::medium, true});
        } else {
            diagram_.arrow(on_paper(ray.origin), on_paper(ray.at(1)), pen);
        }
    }

    /// The rays of the thickest branch are numbered.
    void draw_ray(const Ray<double>& ray, const SurfacePoint<double>& to, int depth, double weight,
                  course::Pen pen) {
        const course::Point a = on_paper(ray.origin), b = on_paper(to.position);
        diagram_.line(a, b, pen);
        const course::Point aside{(b - a).y, (a - b).x};
        if (weight > 0.5)
            diagram_.label(0.5 * (a + b) + 0.2 / length(aside) * (aside.y > 0 ? aside : -aside),
                           std::to_string(depth), course::Anchor::centre, pen.ink);
    }

    static constexpr double left = -3.4;  // where the paper ends

    course::Diagram diagram_;
    Sphere<double>  ball_{{0, 0.15, 0}, 1};
    Plane<double>   floor_{{0, -1.4, 0}, {0, 1, 0}};
    Plane<double>   mirror_{{3.1, 0, 0}, {-1, 0, 0}};
    Vector3<double> light_{1.2, 2.4, 0};
    double          n_ = 1.5;
};

}  // namespace sr
