#pragma once
/// @file progressive_shooting.hpp

#include <cstddef>

#include "radiosity/radiosity_solver.hpp"

namespace sr {

/// The patch with the most unshot power sends it to all others, which asks for one row of F and none of the others: by
/// reciprocity F_ji = F_ij A_i / A_j. It is Southwell's method with another choice of the patch and with what is
/// unshot counted in, since it has arrived already. A step is one patch and costs n.
/// @pre A_i F_ij = A_j F_ji
/// @see Cohen, Chen, Wallace and Greenberg, A Progressive Refinement Approach to Fast Radiosity Image Generation
///      (SIGGRAPH 1988)
class ProgressiveShooting {
public:
    explicit ProgressiveShooting(const RadiositySystem&&) = delete;  ///< it would be gone
    explicit ProgressiveShooting(const RadiositySystem& system);

    void step();

    /// What has been shot and what has arrived: complete but for what the unshot still does elsewhere.
    [[nodiscard]] Radiosities radiosities() const;

    /// The same for display: the unshot light is taken to be spread over the scene and reflected on by its mean
    /// reflectance, equation (8.20). Never part of the solution: it gets less as that gets better. In an open scene
    /// some of it leaves: rho_i sum_j F_ij stands for rho_i, which would be too bright. Costs n^2 for these sums.
    [[nodiscard]] Radiosities radiosities_with_ambient() const;

    /// What is unshot.
    [[nodiscard]] double residual() const;

private:
    [[nodiscard]] std::size_t brightest() const;

    const RadiositySystem& system_;
    Radiosities            shot_;
    Radiosities            unshot_;
};

}  // namespace sr
