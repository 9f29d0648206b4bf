#pragma once
/// @file photons.hpp

#include <concepts>

#include "radiometry/quantity.hpp"

namespace sr {

/// The energy of one photon, Q = h c / wavelength, equation (5.2). Planck's constant and the speed of light are
/// exact: since 2019 the SI's units are defined by them.
/// @param wavelength  in vacuum, > 0: 555e-9 m is where the eye is most sensitive
template <std::floating_point T>
[[nodiscard]] constexpr Energy<T> photon_energy(Length<T> wavelength) {
    constexpr double h = 6.62607015e-34;  // [J s]
    constexpr double c = 299'792'458;     // [m/s]
    return Energy<T>{T(h * c / double(wavelength.value()))};
}

/// How many photons of one wavelength carry the flux.
template <std::floating_point T>
[[nodiscard]] constexpr Rate<T> photons_per_time(Flux<T> flux, Length<T> wavelength) {
    return flux / photon_energy(wavelength);
}

}  // namespace sr
