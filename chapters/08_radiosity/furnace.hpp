#pragma once
/// @file furnace.hpp
/// The smallest radiosity system: a closed room of one colour in which all emit 1, B = 1 + rho B.

#include <concepts>

namespace sr {

/// Where an iteration stopped because it changed nothing any more, and after how many steps that did.
template <std::floating_point T>
struct Stopped {
    T   radiosity;
    int steps;
};

/// B = emission + rho B in one precision, from 0.
template <std::floating_point T>
[[nodiscard]] Stopped<T> furnace(T rho, T emission = 1) {
    T B = 0;
    for (int steps = 0;; ++steps) {
        const T next = emission + rho * B;
        if (!(next != B)) return {B, steps};
        B = next;
    }
}

/// The same in float, but for the residual, which is a double: what is missing solves the same equation with the
/// residual for an emission, and what is missing of that again.
[[nodiscard]] inline Stopped<double> refined_furnace(float rho) {
    double B     = 0;
    int    steps = 0;
    for (int round = 0; round < 20; ++round) {
        const double residual = 1 - (B - double(rho) * B);
        const auto   missing  = furnace(rho, float(residual));
        const double next     = B + double(missing.radiosity);
        steps += missing.steps;
        if (!(next != B)) break;
        B = next;
    }
    return {B, steps};
}

}  // namespace sr
