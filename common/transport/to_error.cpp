/// @file to_error.cpp

#include "transport/to_error.hpp"

#include "math/square.hpp"
#include "statistics/running.hpp"

namespace sr {
namespace {

constexpr int around = 2;  // pixels to each side

/// Standard deviation of a pass: root of the mean variance of the pixels around that count.
double deviation(const Image<float>& errors, const PixelMask& mask, int x, int y) {
    Running variances;
    for (int v = std::max(y - around, 0); v <= std::min(y + around, mask.height() - 1); ++v)
        for (int u = std::max(x - around, 0); u <= std::min(x + around, mask.width() - 1); ++u)
            if (mask(u, v) != 0) variances.add(square(double(errors(u, v))));
    return std::sqrt(variances.mean());
}

}  // namespace

Image<double> pass_shares(const SampledImage& pilot, const PixelMask& mask, double evenly) {
    const auto    errors = pilot.standard_errors();
    Image<double> shares(mask.width(), mask.height(), 1);
    Running       deviations;
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x)
            if (mask(x, y) != 0) deviations.add(shares(x, y) = deviation(errors, mask, x, y));
    if (!(deviations.mean() > 0)) return {mask.width(), mask.height(), 1};
    for (std::size_t i = 0; i < mask.pixels().size(); ++i)
        if (double& share = shares.pixels()[i]; mask.pixels()[i] != 0)
            share = evenly + (1 - evenly) * share / deviations.mean();
    return shares;
}

bool any_pixel(const PixelMask& mask, const std::function<bool(int x, int y)>& test) {
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x)
            if (test(x, y)) return true;
    return false;
}

}  // namespace sr
