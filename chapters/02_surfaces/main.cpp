/// @file main.cpp
/// Chapter 2, surfaces: what a ray meets when a surface is an equation.

#include "any_surface.hpp"
#include "course/chapter.hpp"

namespace sr {
namespace {

/// 2.1  Where does a ray meet what an equation describes?
void surface_is_an_equation(course::Chapter& chapter) {
    chapter.section("2.1 A surface is an equation");
}

}  // namespace
}  // namespace sr

int main(int argc, char** argv) {
    using namespace sr;
    return course::run(argc, argv, "02_surfaces", "Surfaces", [](course::Chapter& chapter) {
        surface_is_an_equation(chapter);
        any_surface(chapter);
        any_surface_speed(chapter);
        normals(chapter);
    });
}
