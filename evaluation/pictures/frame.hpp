#pragma once

#include "evaluation/reproduce/stage.hpp"
#include "tools/pelt/picture/still.hpp"

namespace pelt::pictures {

/// A picture of the size that the page shows.
inline reproduce::Picture framed(const char* id, const tools::picture::PovCamera& camera,
                                 const std::string& objects) {
  reproduce::Picture picture =
      reproduce::make_picture({id, ""}, camera, reproduce::white_floor() + objects, {});
  picture.width = 800;
  picture.height = static_cast<std::uint32_t>(800 / camera.aspect);
  return picture;
}

}  // namespace pelt::pictures
