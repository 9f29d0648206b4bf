#pragma once
/// @file bsdf.hpp
/// What all lobes have in common. A lobe is how light is scattered, without its colour: a material weights lobes
/// with spectra (lobe_sum.hpp). Directions are unit vectors of the local frame with normal +z, and both leave
/// the surface: `wo` to the eye, `wi` to the light. `sample` takes a `u` that is uniform in
/// [0, 1)^2.

#include <concepts>
#include <optional>

#include "math/vector.hpp"
#include "sampling/pdf.hpp"

namespace sr {

/// What is carried along a path: radiance, from the eye's point of view, or importance, from a light's, as
/// photons are. Refraction scales the first by n^2 and the second not at all.
/// @see Veach, Robust Monte Carlo Methods for Light Transport Simulation (1997), section 5.2
enum class TransportMode { radiance, importance };

/// A direction that was drawn, and what the light from there counts.
template <std::floating_point T, class Value = T>
struct BsdfSample {
    Vector3<T>               wi;
    Value                    weight;  ///< f cos / pdf, written without the division that could be 0 / 0
    Pdf<measure::SolidAngle> pdf;     ///< of wi; 0 of a delta, which has no density
    bool                     is_delta = false;  ///< wi was drawn from a set of single directions
    T                        squeezed = 1;      ///< the part of the weight that is no loss: n^2 of refraction
};

/// A lobe that sends light into single directions, as mirrors do. Its f is a delta function: there is nothing to
/// evaluate, it can only be sampled.
template <class Lobe, class T>
concept DeltaLobe = requires(const Lobe lobe, Vector3<T> wo, Vector2<T> u, TransportMode mode) {
    { lobe.sample(wo, u, mode) } -> std::same_as<std::optional<BsdfSample<T>>>;
}
&&!requires(const Lobe lobe, Vector3<T> w) {
    lobe.f(w, w);
};

/// What spreads light. f [1/sr] has no cosine in it: that is the reflectance equation's. `pdf(wo, wi)` is the
/// density with which `sample(wo, u, mode)` draws wi.
/// @tparam Value  of f and of a sample's weight: a number for a lobe, a Spectrum for a material
template <class B, class T, class Value = T>
concept Bsdf = requires(const B bsdf, Vector3<T> wo, Vector3<T> wi, Vector2<T> u, TransportMode mode) {
    { bsdf.f(wo, wi) } -> std::same_as<Value>;
    { bsdf.pdf(wo, wi) } -> std::same_as<Pdf<measure::SolidAngle>>;
    { bsdf.sample(wo, u, mode) } -> std::same_as<std::optional<BsdfSample<T, Value>>>;
};

}  // namespace sr
