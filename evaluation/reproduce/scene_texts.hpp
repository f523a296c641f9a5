#pragma once

#include <string_view>

namespace pelt::reproduce {

/// The scenes of evaluation/scenes, so that the command needs no files beside it.
std::string_view approaching_scene();
std::string_view passing_through_scene();
std::string_view crowd_scene();

}  // namespace pelt::reproduce
