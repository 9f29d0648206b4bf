/// @file cornell_box.cpp

#include "scene/cornell_box.hpp"

#include "scene/obj.hpp"

namespace sr {

Scene cornell_box() {
    return read_obj(STERADIAN_SCENE_DATA "/cornell_box.obj");
}

Camera<double> cornell_box_camera(int side) {
    constexpr Vector3<double> position{278, 273, -800}, direction{0, 0, 1}, up{0, 1, 0};
    return pinhole_camera(position, direction, up, cornell_camera::focal_length, cornell_camera::film_side,
                          side, side);
}

}  // namespace sr
