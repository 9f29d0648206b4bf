#pragma once
/// @file gauss_seidel.hpp

#include "radiosity/radiosity_solver.hpp"
#include "radiosity/residual.hpp"

namespace sr {

/// One patch after the other gets what makes its own equation hold, equation (8.19), from what the others have by
/// then. A step is a sweep over all of them and costs n^2; it can't be shared out to threads.
/// @see Golub and Van Loan, Matrix Computations (4th edition, 2013), section 11.2
class GaussSeidel {
public:
    explicit GaussSeidel(const RadiositySystem&&) = delete;  ///< it would be gone
    explicit GaussSeidel(const RadiositySystem& system)
        : system_{system}, radiosities_(system.size()), residuals_{system.emission} {}

    void step() {
        for (std::size_t i = 0; i < system_.size(); ++i) {
            const DoubleSpectrum received = irradiance(system_.form_factors, radiosities_, i);
            residuals_[i]   = system_.emission[i] - (radiosities_[i] - system_.reflectance[i] * received);
            radiosities_[i] = radiosities_[i] + residuals_[i] / diagonal(system_, i);
        }
    }

    [[nodiscard]] const Radiosities& radiosities() const { return radiosities_; }

    /// As the patches had it when it was their turn: that of all at one time would cost a second sweep.
    [[nodiscard]] double residual() const { return relative_size(residuals_, system_.emission); }

private:
    const RadiositySystem& system_;
    Radiosities            radiosities_;
    Radiosities            residuals_;
};

}  // namespace sr
