#pragma once
/// @file southwell.hpp

#include <algorithm>

#include "radiosity/radiosity_solver.hpp"
#include "radiosity/residual.hpp"

namespace sr {

/// The patch with the largest residual gets what makes its equation hold, equation (8.19). A step is one patch and
/// costs n: it changes the residuals of the others by a column of F.
/// @see Southwell, Relaxation Methods in Engineering Science (1940)
class Southwell {
public:
    explicit Southwell(const RadiositySystem&&) = delete;  ///< it would be gone
    explicit Southwell(const RadiositySystem& system)
        : system_{system}, radiosities_(system.size()), residuals_{system.emission} {}

    void step() {
        const auto less = [](const DoubleSpectrum& s, const DoubleSpectrum& t) {
            return largest(s) < largest(t);  // they stay positive: light is only ever added
        };
        const auto i =
            std::size_t(std::max_element(residuals_.begin(), residuals_.end(), less) - residuals_.begin());
        const DoubleSpectrum change = residuals_[i] / diagonal(system_, i);
        radiosities_[i]             = radiosities_[i] + change;
        residuals_[i]               = {};
        // what the others now miss
        for (std::size_t j = 0; j < system_.size(); ++j) {
            if (j == i) continue;
            residuals_[j] = residuals_[j] + system_.form_factors(j, i) * system_.reflectance[j] * change;
        }
    }

    [[nodiscard]] const Radiosities& radiosities() const { return radiosities_; }
    [[nodiscard]] double             residual() const { return relative_size(residuals_, system_.emission); }

private:
    const RadiositySystem& system_;
    Radiosities            radiosities_;
    Radiosities            residuals_;
};

}  // namespace sr
