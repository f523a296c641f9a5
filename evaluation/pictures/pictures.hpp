#pragma once

/// The pictures of docs/queries.md and docs/self-collision.md, each drawn from the result of its
/// query.

#include "evaluation/reproduce/report.hpp"

namespace pelt::pictures {

using reproduce::Picture;

// query_pictures.cpp
Picture bounds_picture();
Picture culling_picture();
Picture ray_picture();
Picture distance_picture();
Picture contact_picture();
Picture terrain_picture();
Picture inside_picture();

// skinning_pictures.cpp
Picture morph_picture();
Picture skinning_picture();

// self_pictures.cpp: contacts of a character with itself
Picture through_picture();
Picture resting_picture();
Picture crease_picture();

}  // namespace pelt::pictures
