/// @file quadtrees.cpp

#include "radiosity/quadtrees.hpp"

namespace sr {

Quadtrees::Quadtrees(std::span<const Polygon> polygons) : polygons_(polygons.begin(), polygons.end()) {
    for (std::uint32_t i = 0; i < polygons_.size(); ++i) nodes_.push_back({polygons_[i].shape, i});
}

std::uint32_t Quadtrees::children(std::uint32_t node) {
    if (nodes_[node].is_leaf()) {
        const auto polygon       = nodes_[node].polygon;
        const auto quarters      = nodes_[node].shape.quarters();
        nodes_[node].first_child = std::uint32_t(nodes_.size());
        for (const auto& quarter : quarters) nodes_.push_back({quarter, polygon});
    }
    return nodes_[node].first_child;
}

Radiosities Quadtrees::push_pull(Radiosities gathered) const {
    Radiosities radiosities(size());
    // parents come before their children: downwards is forwards
    for (std::size_t i = 0; i < size(); ++i) {
        if (nodes_[i].is_leaf()) continue;
        for (std::size_t k = nodes_[i].first_child; k < nodes_[i].first_child + 4; ++k)
            gathered[k] = gathered[k] + gathered[i];
    }
    // and upwards is backwards
    for (std::size_t i = size(); i-- > 0;) {
        if (nodes_[i].is_leaf()) {
            radiosities[i] = polygon_of(i).emission + polygon_of(i).reflectance * gathered[i];
            continue;
        }
        DoubleSpectrum flux;
        for (std::size_t k = nodes_[i].first_child; k < nodes_[i].first_child + 4; ++k)
            flux = flux + nodes_[k].shape.area() * radiosities[k];
        radiosities[i] = flux / nodes_[i].shape.area();
    }
    return radiosities;
}

Patches Quadtrees::leaves() const {
    Patches patches;
    for (const auto& [shape, polygon, first_child] : nodes_) {
        if (first_child != 0) continue;
        const auto p     = shape.corners();
        const auto first = std::uint32_t(patches.vertices.size());
        const auto last  = std::uint32_t(first + p.size() - 1);
        patches.vertices.insert(patches.vertices.end(), p.begin(), p.end());
        patches.corners.push_back({first, first + 1, first + 2, last});
        patches.shapes.push_back(shape);
        patches.reflectance.push_back(polygons_[polygon].reflectance);
        patches.emission.push_back(polygons_[polygon].emission);
        patches.polygon.push_back(polygon);
    }
    return patches;
}

Radiosities Quadtrees::of_leaves(const Radiosities& radiosities) const {
    Radiosities result;
    for (std::size_t i = 0; i < size(); ++i)
        if (nodes_[i].is_leaf()) result.push_back(radiosities[i]);
    return result;
}

std::size_t Quadtrees::bytes() const {
    return nodes_.capacity() * sizeof(QuadtreeNode) + polygons_.capacity() * sizeof(Polygon);
}

}  // namespace sr
