#pragma once
/// @file cosine_rays.hpp

#include <cstddef>
#include <vector>

#include "geometry/hierarchy.hpp"
#include "radiosity/patches.hpp"
#include "sampling/rng.hpp"

namespace sr {

/// A row of form factors at a time, as light would find them: rays leave random points of a patch into directions
/// drawn by the cosine, and each adds its share to the patch that it meets. No cosine and no distance is computed,
/// nothing is unbounded, and in a closed scene each row adds up to 1. But F_ij and F_ji come from other rays, and are
/// not reciprocal.
/// @see Malley, A Shading Method for Computer Generated Images, thesis, University of Utah (1988)
class CosineRays {
public:
    explicit CosineRays(const Patches& patches);

    /// Row i [1] by side^2 rays, whose points and directions are stratified. What meets a patch from behind is lost.
    /// The standard error of F is at most about sqrt(F (1 - F)) / side: the smaller F, the larger a share of it.
    /// @pre side >= 1
    [[nodiscard]] std::vector<double> row(std::size_t i, int side, Rng& rng) const;

private:
    std::vector<Patch> shapes_;
    PatchMesh          seen_;
    Hierarchy<double>  hierarchy_;
};

}  // namespace sr
