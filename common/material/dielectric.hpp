#pragma once
/// @file dielectric.hpp

#include <cmath>
#include <concepts>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "material/bsdf.hpp"
#include "material/fresnel.hpp"
#include "material/reflect.hpp"

namespace sr {

/// The two ways that light takes at a smooth surface between transparent media. Their weights are what light from
/// there counts; without the scaling of radiance by n^2 they sum to 1.
template <std::floating_point T>
struct Branches {
    BsdfSample<T>                reflected;
    std::optional<BsdfSample<T>> refracted;  ///< none where light is reflected totally
};

/// A smooth surface with vacuum above (+z) and a transparent medium, glass or water, below.
template <std::floating_point T>
class Dielectric {
public:
    /// @param index_of_refraction  of the medium below over that above, > 0 [1]; 1.5 is glass
    /// @throws std::invalid_argument if it is not positive and finite
    explicit Dielectric(T index_of_refraction) : n_{index_of_refraction} {
        if (!(n_ > 0 && std::isfinite(n_)))
            throw std::invalid_argument(fmt::format(
                "index of refraction is {}; it must be positive and finite, such as 1.5 for glass", n_));
    }

    [[nodiscard]] T index_of_refraction() const { return n_; }

    /// Both ways. Radiance that is refracted is scaled by (n_o / n_i)^2, because the cone that carries it gets
    /// narrower or wider; importance, the flux of photons, is not.
    /// @param wo  on either side
    /// @see   Veach (1997), section 5.2
    [[nodiscard]] Branches<T> branches(const Vector3<T>& wo, TransportMode mode) const {
        const T     eta       = wo.z > 0 ? n_ : 1 / n_;
        const auto  direction = refract(wo, eta);
        const T     R         = direction ? fresnel(std::abs(wo.z), eta).mean() : T{1};
        Branches<T> both{{reflect(wo), R, {}, true}, {}};
        // the same light in a cone n^2 as wide or as narrow; photons are counted, wherever they go
        const T     scale = mode == TransportMode::radiance ? 1 / (eta * eta) : T{1};
        if (direction) both.refracted = {*direction, (1 - R) * scale, {}, true, scale};
        return both;
    }

    /// One of the two, each as often as its share of the light.
    [[nodiscard]] std::optional<BsdfSample<T>> sample(const Vector3<T>& wo, Vector2<T> u,
                                                      TransportMode mode) const {
        const Branches<T> both     = branches(wo, mode);
        const T           R        = both.reflected.weight;
        const bool        reflects = u.x < R || R == 1;  // where all light is reflected, a u of 1 is as well
        BsdfSample<T>     one      = reflects ? both.reflected : *both.refracted;
        one.weight /= reflects ? R : 1 - R;
        return one;
    }

private:
    T n_;
};

}  // namespace sr
