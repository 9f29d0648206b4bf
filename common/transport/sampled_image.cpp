/// @file sampled_image.cpp

#include "transport/sampled_image.hpp"

namespace sr {

void SampledImage::Pixel::add(DoubleSpectrum L) {
    sum = sum + L;
    brightness.add(sr::mean(L));
}

Image<Spectrum> SampledImage::mean() const {
    Image<Spectrum> film(camera_.width, camera_.height);
    for (int y = 0; y < camera_.height; ++y)
        for (int x = 0; x < camera_.width; ++x)
            if (const auto& pixel = pixels_(x, y); pixel.brightness.count() > 0)
                film(x, y) = convert<float>(pixel.sum / double(pixel.brightness.count()));
    return film;
}

Image<float> SampledImage::standard_errors() const {
    Image<float> errors(camera_.width, camera_.height);
    for (int y = 0; y < camera_.height; ++y)
        for (int x = 0; x < camera_.width; ++x)
            errors(x, y) = float(pixels_(x, y).brightness.standard_error());
    return errors;
}

double SampledImage::relative_error() const {
    return relative_error(PixelMask(camera_.width, camera_.height, 1));
}

double SampledImage::relative_error(const PixelMask& mask) const {
    double  sum = 0;
    Running brightness;
    for (std::size_t i = 0; i < mask.pixels().size(); ++i) {
        if (mask.pixels()[i] == 0) continue;
        const Running& pixel = pixels_.pixels()[i].brightness;
        if (pixel.count() < 2) return std::numeric_limits<double>::infinity();
        sum += pixel.variance() / double(pixel.count());
        brightness.add(pixel.mean());
    }
    return std::sqrt(sum / double(brightness.count())) / brightness.mean();
}

std::uint64_t SampledImage::samples() const {
    std::uint64_t passes = 0;
    for (const auto& pixel : pixels_.pixels()) passes += pixel.brightness.count();
    return passes * options_.samples;
}

}  // namespace sr
