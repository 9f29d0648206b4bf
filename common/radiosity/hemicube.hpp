#pragma once
/// @file hemicube.hpp

#include <cstddef>
#include <vector>

#include "radiosity/patches.hpp"

namespace sr {

/// A row of form factors at a time, as a rasteriser finds them: half a cube is put around the middle of a patch, the
/// scene is drawn onto its five faces, and each pixel counts for what is seen through it, equation (8.12). It has one
/// eye, where light leaves a whole patch; and it sees in pixels.
/// @see Cohen and Greenberg, The Hemi-Cube, Computer Graphics 19(3), 1985
class Hemicube {
public:
    /// @param resolution  pixels along an edge of the whole cube
    /// @throws std::invalid_argument unless that is even and at least 2
    Hemicube(const Patches& patches, int resolution);

    /// Row i [1]. What is seen from behind is lost. Of opposite faces of a cube, pixels make F wrong by up to a share
    /// of
    /// 0.7 / resolution; and one eye by 19.8 % at any resolution, less as the square of the patch's size over its
    /// distance.
    [[nodiscard]] std::vector<double> row(std::size_t i) const;

private:
    std::vector<Patch>  shapes_;
    PatchMesh           seen_;
    int                 resolution_;
    std::vector<double> top_,
        side_;  ///< form factors of pixels: all of the top face, the upper half of a side
};

}  // namespace sr
