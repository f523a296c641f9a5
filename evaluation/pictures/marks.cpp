#include "evaluation/pictures/marks.hpp"

#include "tools/pelt/scene/scene_query.hpp"

#include <cstdio>
#include <cstdlib>

namespace pelt::pictures {
namespace {

using reproduce::unit;
using tools::picture::pov_vector;

template <typename T>
T demand(Result<T> result) {
  if (result) return std::move(*result);
  std::fprintf(stderr, "%s\n", result.error().message.c_str());
  std::exit(1);
}

Pose pose_of(const scenes::Scene& scene, std::size_t instance,
             const tools::scene::Palettes& palettes) {
  const asset::Asset& asset = scene.characters[scene.instances[instance].character].asset;
  Pose pose(demand(build_model(asset.mesh())));
  if (!pose.set_palette(palettes[instance]) || !pose.set_morph_weights(palettes.morphs[instance]))
    std::abort();
  return pose;
}

}  // namespace

Cast::Cast(std::string_view scene_text, std::uint32_t frame)
    : Cast(demand(scenes::parse_scene(scene_text, {})), frame) {}

Cast::Cast(scenes::Scene scene, std::uint32_t frame)
    : scene_(std::make_unique<scenes::Scene>(std::move(scene))) {
  asset::SampleScratch scratch;
  tools::scene::Palettes palettes;
  tools::scene::sample_palettes(*scene_, frame, scratch, palettes);
  std::vector<tools::scene::PosedInstance> posed =
      demand(tools::scene::pose_instances(*scene_, frame, {}));
  for (std::size_t i = 0; i < posed.size(); ++i)
    actors.push_back({pose_of(*scene_, i, palettes), std::move(posed[i])});
}

namespace {

std::string texture_of(Tone tone) {
  const char* colour = tone == Tone::answer     ? "<0.95,0.22,0.02>"
                       : tone == Tone::question ? "<0.03,0.20,0.50>"
                                                : "<0.42,0.44,0.47>";
  return std::string(" pigment {rgb ") + colour + "} finish {diffuse 0.35 ambient 0 emission 0.6}";
}

}  // namespace

std::string dot_at(const Vec3d& place, double radius, Tone tone) {
  return "sphere {" + pov_vector(place) + ", " + std::to_string(radius) + texture_of(tone) +
         " no_shadow}\n";
}

std::string line(const Vec3d& from, const Vec3d& to, double radius, Tone tone) {
  if (squared_length(to - from) == 0) return {};  // POV-Ray rejects these
  return "cylinder {" + pov_vector(from) + ", " + pov_vector(to) + ", " + std::to_string(radius) +
         texture_of(tone) + " no_shadow}\n";
}

std::string arrow(const Vec3d& from, const Vec3d& to, double radius, Tone tone) {
  const Vec3d neck = to - (7 * radius) * unit(to - from);
  return line(from, neck, radius, tone) + "cone {" + pov_vector(neck) + ", " +
         std::to_string(3 * radius) + ", " + pov_vector(to) + ", 0" + texture_of(tone) +
         " no_shadow}\n";
}

std::string edges(const Box& box, double radius, Tone tone) {
  const auto corner = [&](int bits) {
    return Vec3d(Vec3{bits & 1 ? box.high.x : box.low.x, bits & 2 ? box.high.y : box.low.y,
                      bits & 4 ? box.high.z : box.low.z});
  };
  std::string text;
  for (int from = 0; from < 8; ++from) {
    text += dot_at(corner(from), radius, tone);
    for (const int axis : {1, 2, 4})
      if (!(from & axis)) text += line(corner(from), corner(from | axis), radius, tone);
  }
  return text;
}

std::string painted(const Actor& actor, std::size_t skin) {
  return painted(actor, reproduce::skin_texture(skin), {});
}

std::string painted(const Actor& actor, const std::string& texture,
                    const std::vector<bool>& marked) {
  const std::vector<bool> none(actor.posed.triangles.size());
  return tools::picture::pov_mesh(actor.posed, marked.empty() ? none : marked, texture);
}

std::string unshadowed(const std::string& mesh) { return "object {" + mesh + "no_shadow}\n"; }

std::string glass(const std::array<float, 3>& colour, double through) {
  std::string pigment = tools::picture::pov_colour(colour);
  pigment.insert(pigment.find('>'), "," + std::to_string(through));
  pigment.replace(0, 3, "rgbt");
  return "pigment {" + pigment +
         "} finish {diffuse 0.75 specular 0.2 roughness 0.05 ambient 0 "
         "emission 0.06}";
}

std::string paint(const std::array<float, 3>& colour) {
  return "Matt(" + tools::picture::pov_colour(colour) + ")";
}

}  // namespace pelt::pictures
