/// @file progressive_shooting.cpp

#include "radiosity/progressive_shooting.hpp"

#include "radiosity/residual.hpp"

namespace sr {

ProgressiveShooting::ProgressiveShooting(const RadiositySystem& system)
    : system_{system}, shot_(system.size()), unshot_{system.emission} {}

void ProgressiveShooting::step() {
    const std::size_t    i      = brightest();
    const DoubleSpectrum change = unshot_[i] / diagonal(system_, i);  // with what comes back from itself
    shot_[i]                    = shot_[i] + change;
    unshot_[i]                  = {};
    const auto row              = system_.form_factors.row(i);
    for (std::size_t j = 0; j < row.size(); ++j) {
        if (j == i) continue;
        const double from_i = row[j] * system_.area[i] / system_.area[j];  // F_ji
        unshot_[j]          = unshot_[j] + from_i * system_.reflectance[j] * change;
    }
}

std::size_t ProgressiveShooting::brightest() const {
    std::size_t best = 0;
    double      most = 0;
    for (std::size_t i = 0; i < system_.size(); ++i) {
        const double power = system_.area[i] * mean(unshot_[i]);
        if (!(power > most)) continue;
        best = i;
        most = power;
    }
    return best;
}

Radiosities ProgressiveShooting::radiosities() const {
    Radiosities sum = shot_;
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = sum[i] + unshot_[i];
    return sum;
}

Radiosities ProgressiveShooting::radiosities_with_ambient() const {
    DoubleSpectrum reflected, power;
    double         area = 0;
    // of light that comes from all around, what a patch sends on: what it sees of the others, and reflects
    const auto     reflectance = [&](std::size_t i) {
        return system_.form_factors.row_sum(i) * system_.reflectance[i];
    };
    for (std::size_t i = 0; i < system_.size(); ++i) {
        area      = area + system_.area[i];
        reflected = reflected + system_.area[i] * reflectance(i);
        power     = power + system_.area[i] * unshot_[i];
    }
    // (8.20) mean unshot radiosity times 1 + rho + rho^2 + ...
    const DoubleSpectrum ambient = power / (DoubleSpectrum{area, area, area} - reflected);
    Radiosities          shown   = radiosities();
    for (std::size_t i = 0; i < shown.size(); ++i) shown[i] = shown[i] + reflectance(i) * ambient;
    return shown;
}

double ProgressiveShooting::residual() const {
    return relative_size(unshot_, system_.emission);
}

}  // namespace sr
