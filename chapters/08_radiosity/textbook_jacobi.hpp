#pragma once
/// @file textbook_jacobi.hpp

#include "radiosity/residual.hpp"

namespace sr {

/// Relaxed Jacobi as (8.16) has it, which doesn't ask whether its lambda is stable.
class TextbookJacobi {
public:
    TextbookJacobi(const RadiositySystem& system, double lambda)
        : system_{system}, lambda_{lambda}, radiosities_(system.size()) {}

    void step() {
        const Radiosities r = residuals(system_, radiosities_, 1);
        for (std::size_t i = 0; i < r.size(); ++i)
            radiosities_[i] = radiosities_[i] + lambda_ * r[i] / diagonal(system_, i);
    }

    [[nodiscard]] const Radiosities& radiosities() const { return radiosities_; }

private:
    const RadiositySystem& system_;
    double                 lambda_;
    Radiosities            radiosities_;
};

}  // namespace sr
