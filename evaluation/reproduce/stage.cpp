#include "evaluation/reproduce/stage.hpp"

#include <cmath>

namespace pelt::reproduce {
namespace {

using detail::Vec3d;
using tools::picture::pov_vector;
using tools::picture::PovCamera;

constexpr double kPi = 3.14159265358979323846;

}  // namespace

double length(const Vec3d& v) { return std::sqrt(squared_length(v)); }

Vec3d unit(const Vec3d& v) { return (1 / length(v)) * v; }

View::View(const tools::picture::PovCamera& camera)
    : ahead(unit(camera.at - camera.from)),
      right(unit(cross(ahead, Vec3d(0, 1, 0)))),
      up(cross(right, ahead)),
      from_(camera.from),
      width_(2 * std::tan(camera.angle * kPi / 360)),
      height_(width_ / camera.aspect) {}

double View::width_at(const Vec3d& place) const { return width_ * dot(place - from_, ahead); }

Vec3d View::seen_at(double x, double y, double depth) const {
  const double half = 0.5 * height_ * depth;
  return from_ + depth * ahead + (x * half) * right + (y * half) * up;
}

namespace {

constexpr const char* kMaterials = R"(#version 3.7;
global_settings {assumed_gamma 1}
background {rgb 1}
#macro Matt(Colour)
  pigment {Colour} finish {diffuse 0.75 specular 0.12 roughness 0.06 ambient 0 emission 0.06}
#end
#declare Glow = texture {pigment {rgb <1,0.13,0>} finish {diffuse 0.15 ambient 0 emission 0.9}}
#declare BlueBall = texture {Matt(rgb <0.02,0.24,0.72>)}
#declare RedBall = texture {Matt(rgb <0.86,0.26,0.16>)}
#declare Floor = texture {pigment {rgb 1} finish {diffuse 0.9 ambient 0 emission 0.3}}
#declare Edge = texture {pigment {rgb 0.05} finish {diffuse 0.3 ambient 0 emission 0.4}}
#declare Rim = texture {pigment {rgb 0.12} finish {diffuse 0 ambient 0 emission 1}}
#declare Backdrop = texture {pigment {rgb 0.93} finish {diffuse 0 ambient 0 emission 1}}
#declare Ink = texture {pigment {rgb 0.06} finish {diffuse 0 ambient 0 emission 1}}
)";

/// Slate, sand, moss and plum, pale enough for the glow to stand out.
constexpr std::array<std::array<float, 3>, 4> kSkins = {
    {{0.26F, 0.40F, 0.55F}, {0.66F, 0.57F, 0.42F}, {0.42F, 0.52F, 0.40F}, {0.54F, 0.42F, 0.48F}}};

/// The height of letters over the width of a square picture.
constexpr double kLetters = 0.033;

/// Farther than anything in a picture.
constexpr double kFar = 30;

/// A large key light from the upper left, a sky, and a weak fill light from the right, all as far
/// away as the sun, so that the floor is evenly bright.
std::string lights(const PovCamera& camera) {
  const View view(camera);
  const Vec3d level = unit(Vec3d(view.ahead.x, 0, view.ahead.z));
  const auto light = [&](const Vec3d& at, const char* colour) {
    const Vec3d from = kFar * (at.x * view.right + Vec3d(0, at.y, 0) + at.z * level);
    return "light_source {" + pov_vector(camera.at + from) + " rgb " + colour +
           " parallel point_at " + pov_vector(camera.at);
  };
  const auto area = [](double width) {
    const std::string side = std::to_string(width * kFar);
    return " area_light <" + side + ",0,0>, <0,0," + side + ">, 5, 5 adaptive 1 circular orient}\n";
  };
  return light({-0.7, 1.0, -0.75}, "<0.78,0.76,0.72>") + area(0.25) +
         light({0.1, 1.4, 0.1}, "<0.40,0.42,0.46>") + area(1.0) +
         light({1.0, 0.5, -0.7}, "<0.18,0.19,0.21>") + " shadowless}\n";
}

}  // namespace

std::string white_floor() { return "plane {y, 0 texture {Floor}}\n"; }

std::string pedestal(const Vec3d& top) {
  return "cylinder {" + pov_vector(top - Vec3d(0, 0.03, 0)) + ", " + pov_vector(top) +
         ", 0.55 texture {Matt(rgb 0.8)}}\n";
}

std::string ball(const Vec3d& centre, double radius, const char* texture) {
  return "sphere {" + pov_vector(centre) + ", " + std::to_string(radius) + " texture {" + texture +
         "}}\n";
}

std::string skin_texture(std::size_t skin) {
  return "Matt(" + tools::picture::pov_colour(kSkins[skin % kSkins.size()]) + ")";
}

std::string mesh_in_skin(const tools::scene::PosedInstance& instance,
                         const std::vector<bool>& touching, std::size_t skin) {
  return tools::picture::pov_mesh(instance, touching, skin_texture(skin));
}

std::string characters(const tools::picture::StillFrame& still) {
  std::string text;
  for (std::size_t i = 0; i < still.instances.size(); ++i)
    text += mesh_in_skin(still.instances[i], still.touching[i], i);
  return text;
}

std::string moved(const std::string& objects, const Vec3d& by) {
  return "union {\n" + objects + "translate " + pov_vector(by) + "}\n";
}

std::string word(const std::string& letters, const Vec3d& place, const PovCamera& camera) {
  const View view(camera);
  const double size = kLetters / std::sqrt(camera.aspect) * view.width_at(place);
  const auto axis = [&](const Vec3d& v) {
    const std::string numbers = pov_vector(size * v);
    return numbers.substr(1, numbers.size() - 2) + ", ";
  };
  const std::string at = pov_vector(place);
  return "#declare Word = text {internal 2 \"" + letters + "\" 0.01, 0}\n" +
         "object {Word translate -0.5*x*(min_extent(Word).x + max_extent(Word).x) matrix <" +
         axis(view.right) + axis(view.up) + axis(view.ahead) + at.substr(1) +
         " texture {Ink} no_shadow}\n";
}

Picture make_picture(const Caption& caption, const PovCamera& camera, const std::string& objects,
                     const Conditions& conditions) {
  constexpr double kPixels = 960 * 540;
  const double pixels = conditions.is_quick ? kPixels / 3 : kPixels;
  const auto width = static_cast<std::uint32_t>(std::lround(std::sqrt(pixels * camera.aspect)));
  const auto height = static_cast<std::uint32_t>(std::lround(width / camera.aspect));
  return {caption.id, caption.text, kMaterials + pov_camera(camera) + lights(camera) + objects,
          width, height};
}

}  // namespace pelt::reproduce
