/// A creature in a hilly field, the triangles of both that touch, and the distance of the creature
/// from a pillar.

#include "evaluation/pictures/frame.hpp"
#include "evaluation/pictures/marks.hpp"
#include "evaluation/pictures/pictures.hpp"

#include <pelt/height_field.hpp>
#include <pelt/solid.hpp>

#include "tools/pelt/picture/still.hpp"

#include <cmath>

namespace pelt::pictures {
namespace {

constexpr std::string_view kScene = R"({
  "models": {"a": {"creature": {"triangles": 24000, "joints": 56, "seed": 1}}},
  "instances": [{"model": "a", "clip": "walk", "start": 1.3, "translation": [0, 0.06, 0]}]})";

constexpr std::uint32_t kColumns = 41, kRows = 61;
constexpr float kSpacing = 0.08f;
constexpr double kGround = 0.25;  // its mean height: above the floor of the picture

std::vector<float> hills() {
  std::vector<float> heights;
  for (std::uint32_t row = 0; row < kRows; ++row) {
    for (std::uint32_t column = 0; column < kColumns; ++column) {
      const double x = column * double{kSpacing}, z = row * double{kSpacing};
      heights.push_back(static_cast<float>(kGround +
                                           0.09 * std::sin(3.1 * x + 1) * std::cos(2.3 * z) +
                                           0.05 * std::sin(1.3 * z + 2)));
    }
  }
  return heights;
}

std::string painted(const HeightField& field, const std::vector<bool>& touched) {
  std::string text;
  for (std::uint32_t t = 0; t < field.triangle_count(); ++t) {
    const std::array<Vec3, 3> corners = field.triangle(t);
    text += "triangle {" + tools::picture::pov_vector(Vec3d(corners[0])) + ", " +
            tools::picture::pov_vector(Vec3d(corners[1])) + ", " +
            tools::picture::pov_vector(Vec3d(corners[2])) + " texture {" +
            paint(touched[t] ? std::array{0.95f, 0.22f, 0.02f} : std::array{0.62f, 0.66f, 0.55f}) +
            "}}\n";
  }
  return text;
}

}  // namespace

Picture terrain_picture() {
  const std::vector<float> heights = hills();
  const auto field =
      build_height_field({heights, kColumns, kRows, {-1.6f, 0, -2.4f}, kSpacing, kSpacing});
  Cast cast(kScene, 0);
  Actor& actor = cast.actors[0];
  Scratch scratch;
  std::vector<Contact> contacts;
  collide(actor.pose, *field, scratch, contacts);
  std::vector<bool> of_skin(actor.posed.triangles.size()), of_field(field->triangle_count());
  for (const Contact& contact : contacts) {
    of_skin[contact.triangle_a] = true;
    of_field[contact.triangle_b] = true;
  }
  const Capsule pillar = {{0, 0.2f, 1.2f}, {0, 1.3f, 1.2f}, 0.16f};
  SolidDistance closest;
  distance(actor.pose, pillar, scratch, closest);
  const Vec3d from(closest.surface.position), to(closest.solid);
  const std::string stone = "sphere_sweep {linear_spline 2, " +
                            tools::picture::pov_vector(Vec3d(pillar.a)) + ", 0.16, " +
                            tools::picture::pov_vector(Vec3d(pillar.b)) + ", 0.16 texture {" +
                            paint({0.72f, 0.66f, 0.56f}) + "}}\n";
  const std::string objects = painted(actor, paint({0.26f, 0.40f, 0.55f}), of_skin) +
                              painted(*field, of_field) + stone +
                              line(from, to, 0.012, Tone::answer) +
                              dot_at(from, 0.028, Tone::answer) + dot_at(to, 0.028, Tone::answer);
  return framed("terrain", {{-4.4, 2.6, 1.6}, {0, 0.95, 0.25}, 44, 16. / 9}, objects);
}

}  // namespace pelt::pictures
