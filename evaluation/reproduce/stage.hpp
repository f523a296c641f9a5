#pragma once

/// The stage of the report's pictures for POV-Ray: soft light, the white of the page as background,
/// and colours that colour-blind people can distinguish. `View` has positions as a camera sees
/// them.

#include "evaluation/reproduce/report.hpp"
#include "tools/pelt/picture/still.hpp"

namespace pelt::reproduce {

double length(const detail::Vec3d& v);
detail::Vec3d unit(const detail::Vec3d& v);

/// The right, up and forward directions of a camera.
struct View {
  explicit View(const tools::picture::PovCamera& camera);

  /// The width of the visible area at the depth of `place`.
  double width_at(const detail::Vec3d& place) const;

  /// The point `depth` units ahead of the camera that appears at (x, y) from the middle of the
  /// picture, in half heights.
  detail::Vec3d seen_at(double x, double y, double depth) const;

  detail::Vec3d ahead, right, up;

 private:
  detail::Vec3d from_;
  double width_, height_;  // of the visible area at depth 1
};

/// Textures that the stage declares.
inline constexpr const char* kBlueBall = "BlueBall";
inline constexpr const char* kRedBall = "RedBall";

/// A floor at height zero that only shows shadows.
std::string white_floor();

/// A round pedestal whose top has its centre at `top`.
std::string pedestal(const detail::Vec3d& top);

std::string ball(const detail::Vec3d& centre, double radius, const char* texture);

/// One of four quiet colours, by index.
std::string skin_texture(std::size_t skin);

/// Smooth, in the skin with the index `skin`.
std::string mesh_in_skin(const tools::scene::PosedInstance& instance,
                         const std::vector<bool>& touching, std::size_t skin);

/// All characters of a frame, each in another skin. Triangles in contact glow.
std::string characters(const tools::picture::StillFrame& still);

std::string moved(const std::string& objects, const detail::Vec3d& by);

/// Letters that face the camera, centred above `place`, of the same height in every picture.
std::string word(const std::string& letters, const detail::Vec3d& place,
                 const tools::picture::PovCamera& camera);

struct Caption {
  const char *id, *text;
};

/// Has the same number of pixels for every aspect ratio of the camera; a third of them in a quick
/// run.
Picture make_picture(const Caption& caption, const tools::picture::PovCamera& camera,
                     const std::string& objects, const Conditions& conditions);

}  // namespace pelt::reproduce
