/// @file cornell_box.cpp

#include "scene/cornell_box.hpp"

#include "scene/obj.hpp"

namespace sr {

Scene cornell_box() {
    return read_obj(STERADIAN_SCENE_DATA "/cornell_box.obj");
}

}  // namespace sr
