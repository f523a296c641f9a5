#pragma once

/// The pictures of docs/queries.md and docs/self-collision.md, each drawn from the result of its
/// query.

#include "evaluation/reproduce/report.hpp"

namespace pelt::pictures {

using reproduce::Picture;

Picture bounds_picture();    // bounds_picture.cpp
Picture culling_picture();   // culling_picture.cpp
Picture ray_picture();       // ray_picture.cpp
Picture distance_picture();  // distance_picture.cpp
Picture contact_picture();   // contact_picture.cpp
Picture terrain_picture();   // terrain_picture.cpp
Picture inside_picture();    // inside_picture.cpp
Picture morph_picture();     // morph_picture.cpp
Picture skinning_picture();  // skinning_picture.cpp

/// Contacts of a character with itself. All in self_pictures.cpp.
Picture through_picture();
Picture resting_picture();
Picture crease_picture();

}  // namespace pelt::pictures
