#pragma once
/// @file vector.hpp
/// Vectors are GLM's; this file only gives them the course's names. `Vec3` is a float vector, because that
/// is what rendering computes with; `Vector3<double>` is for analysis.

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace sr {

template <class T>
using Vector2 = glm::vec<2, T, glm::defaultp>;
template <class T>
using Vector3 = glm::vec<3, T, glm::defaultp>;

using Vec2 = Vector2<float>;
using Vec3 = Vector3<float>;

using glm::cross;
using glm::dot;
using glm::length;
using glm::normalize;

}  // namespace sr
