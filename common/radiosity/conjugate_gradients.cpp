/// @file conjugate_gradients.cpp

#include "radiosity/conjugate_gradients.hpp"

#include "radiosity/reciprocity.hpp"
#include "radiosity/residual.hpp"

namespace sr {
namespace {

/// a / b, and 0 where nothing is left to be divided.
DoubleSpectrum quotient(const DoubleSpectrum& a, const DoubleSpectrum& b) {
    const auto of = [](double x, double y) { return x == 0 ? 0 : x / y; };
    return {of(a.r, b.r), of(a.g, b.g), of(a.b, b.b)};
}

DoubleSpectrum weight(double area, const DoubleSpectrum& reflectance) {
    const auto of = [&](double rho) { return rho > 0 ? area / rho : 0; };
    return {of(reflectance.r), of(reflectance.g), of(reflectance.b)};
}

}  // namespace

ConjugateGradients::ConjugateGradients(const RadiositySystem& system, int threads)
    : system_{system}, threads_{threads}, radiosities_{system.emission} {
    check_reciprocity(system.form_factors, system.area);
    for (std::size_t i = 0; i < system.size(); ++i)
        weight_.push_back(weight(system.area[i], system.reflectance[i]));
    residuals_ = residuals(system_, radiosities_, threads_);
    direction_ = preconditioned();
    size_      = product(residuals_, direction_);
}

void ConjugateGradients::step() {
    const Radiosities    image  = applied(system_, direction_, threads_);
    const DoubleSpectrum length = quotient(size_, product(direction_, image));
    for (std::size_t i = 0; i < image.size(); ++i) {
        radiosities_[i] = radiosities_[i] + length * direction_[i];
        residuals_[i]   = residuals_[i] - length * image[i];
    }
    const Radiosities    next      = preconditioned();
    const DoubleSpectrum size      = product(residuals_, next);
    const DoubleSpectrum conjugate = quotient(size, size_);
    for (std::size_t i = 0; i < next.size(); ++i) direction_[i] = next[i] + conjugate * direction_[i];
    size_ = size;
}

DoubleSpectrum ConjugateGradients::product(const Radiosities& s, const Radiosities& t) const {
    DoubleSpectrum sum;
    for (std::size_t i = 0; i < s.size(); ++i) sum = sum + weight_[i] * s[i] * t[i];
    return sum;
}

Radiosities ConjugateGradients::preconditioned() const {
    Radiosities result(residuals_.size());
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = residuals_[i] / diagonal(system_, i);
    return result;
}

double ConjugateGradients::residual() const {
    return relative_size(residuals_, system_.emission);
}

}  // namespace sr
