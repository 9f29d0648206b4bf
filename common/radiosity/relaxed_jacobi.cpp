/// @file relaxed_jacobi.cpp

#include "radiosity/relaxed_jacobi.hpp"

#include "radiosity/relaxation.hpp"
#include "radiosity/residual.hpp"

namespace sr {

RelaxedJacobi::RelaxedJacobi(const RadiositySystem& system, double lambda, int threads)
    : system_{system},
      threads_{threads},
      lambda_{lambda},
      radiosities_(system.size()),
      residuals_{system.emission} {
    check_relaxation(system, lambda, threads);
}

void RelaxedJacobi::step() {
    // (8.16) to each what its equation misses
    for (std::size_t i = 0; i < system_.size(); ++i)
        radiosities_[i] = radiosities_[i] + lambda_ * residuals_[i] / diagonal(system_, i);
    residuals_ = residuals(system_, radiosities_, threads_);
}

double RelaxedJacobi::residual() const {
    return relative_size(residuals_, system_.emission);
}

}  // namespace sr
