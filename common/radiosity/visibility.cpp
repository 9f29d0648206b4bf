/// @file visibility.cpp

#include "radiosity/visibility.hpp"

namespace sr {

bool Visibility::between(const SurfacePoint<double>& p, const SurfacePoint<double>& q) const {
    return !hierarchy_.occluded(sr::between(p, q), before_the_end<double>);
}

}  // namespace sr
