#pragma once

/// Characters of a scene, posed for queries and for drawing, and the marks beside them.

#include <pelt/math.hpp>
#include <pelt/pose.hpp>

#include "base/vec3.hpp"
#include "evaluation/reproduce/stage.hpp"
#include "tools/pelt/picture/still.hpp"
#include "tools/pelt/scene/scene_glb.hpp"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace pelt::pictures {

struct Actor {
  Pose pose;
  tools::scene::PosedInstance posed;
};

/// One frame of a scene. Exits with a message if the scene is invalid, because the callers write
/// it.
class Cast {
 public:
  Cast(std::string_view scene_text, std::uint32_t frame);
  Cast(scenes::Scene scene, std::uint32_t frame);

  std::vector<Actor> actors;  ///< in the order of the instances

 private:
  std::unique_ptr<scenes::Scene> scene_;
};

using detail::Vec3d;

/// Tone of lines, dots and skins.
enum class Tone {
  answer,    ///< the result of a query
  question,  ///< the input of the query
  quiet,     ///< everything else
};

std::string dot_at(const Vec3d& place, double radius, Tone tone);
std::string line(const Vec3d& from, const Vec3d& to, double radius, Tone tone);

/// A line that ends in a point.
std::string arrow(const Vec3d& from, const Vec3d& to, double radius, Tone tone);

std::string edges(const Box& box, double radius, Tone tone);

/// Smooth, with a quiet skin.
std::string painted(const Actor& actor, std::size_t skin);

/// The same with another texture: everywhere, or, with the tone of answers, where `marked` is true.
std::string painted(const Actor& actor, const std::string& texture,
                    const std::vector<bool>& marked);

/// A mesh that casts no shadow.
std::string unshadowed(const std::string& mesh);

/// A material that transmits the fraction `through` of the light, from 0 to 1.
std::string glass(const std::array<float, 3>& colour, double through);

/// A matt material of this colour.
std::string paint(const std::array<float, 3>& colour);

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
