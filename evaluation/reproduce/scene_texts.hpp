#pragma once

#include <string_view>

namespace pelt::reproduce {

/// The text of the scenes of evaluation/scenes, so that the program needs no other files.
std::string_view approaching_scene();
std::string_view passing_through_scene();
std::string_view crowd_scene();

}  // namespace pelt::reproduce
