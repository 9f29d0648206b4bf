#pragma once
/// @file visibility.hpp

#include "geometry/hierarchy.hpp"
#include "radiosity/patch.hpp"

namespace sr {

/// What stands between patches: a scene's faces, which hide from either side.
class Visibility {
public:
    explicit Visibility(const Mesh<double>& mesh) : hierarchy_{mesh} {}

    /// V(p, q), whether no face lies between two points of patches. (Which of their sides they turn to each other is
    /// the cosines' business.)
    [[nodiscard]] bool between(const SurfacePoint<double>& p, const SurfacePoint<double>& q) const;

private:
    Hierarchy<double> hierarchy_;
};

}  // namespace sr
