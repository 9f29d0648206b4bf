/// @file cornell_box.cpp

#include "scene/cornell_box.hpp"

#include "scene/obj.hpp"

namespace sr {

Scene cornell_box() {
    Scene scene = read_obj(STERADIAN_SCENE_DATA "/cornell_box.obj");
    for (auto& material : scene.materials) material.shines_behind = false;
    return scene;
}

Scene cornell_box_with_balls() {
    constexpr std::size_t walls_and_lamp = 12;  // faces, before those of the blocks
    Scene                 scene          = cornell_box();
    scene.mesh.faces.resize(walls_and_lamp);
    scene.material_of_face.resize(walls_and_lamp);

    const auto mirror = std::uint32_t(scene.materials.size()), glass = mirror + 1;
    scene.materials.push_back({"mirror", LobeSum<float>{{{{0.9F, 0.9F, 0.9F}, Mirror<float>{}}}}});
    scene.materials.push_back({"glass", LobeSum<float>{{{{1, 1, 1}, Dielectric<float>{1.5F}}}}});
    scene.balls = {{{{390, 105, 370}, 105}, mirror}, {{{165, 95, 190}, 95}, glass}};

    scene.lights.push_back({{278, 420, 279.5}, {3e5F, 2.5e5F, 1.7e5F}});
    return scene;
}

Camera<double> cornell_box_camera(int side) {
    constexpr Vector3<double> position{278, 273, -800}, direction{0, 0, 1}, up{0, 1, 0};
    return pinhole_camera(position, direction, up, cornell_camera::focal_length, cornell_camera::film_side,
                          side, side);
}

}  // namespace sr
