#pragma once
/// @file drawing.hpp
/// What this chapter's diagrams are made of.

#include "course/curves.hpp"

namespace sr {

using course::Anchor;
using course::arc;
using course::draw_angle;
using course::Ink;
using course::Point;
using course::towards;
using course::Weight;

}  // namespace sr
