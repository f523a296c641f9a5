#include "tools/pelt/output/glb_writer.hpp"

#include "scenes/glb_builder.hpp"

namespace pelt::tools::output {
namespace {

using nlohmann::ordered_json;
using scenes::GlbBuilder;

void add_mesh(const GlbMesh& mesh, GlbBuilder& glb) {
  ordered_json attributes;
  attributes["POSITION"] = glb.add_positions(mesh.positions);
  if (!mesh.normals.empty()) attributes["NORMAL"] = glb.add_vectors(mesh.normals);
  ordered_json primitives = ordered_json::array();
  for (const GlbPrimitive& primitive : mesh.primitives) {
    primitives.push_back({{"attributes", attributes},
                          {"indices", glb.add_indices(primitive.triangles)},
                          {"material", primitive.material}});
  }
  ordered_json& json = glb.json;
  const std::size_t number = json["meshes"].size();
  json["meshes"].push_back({{"name", mesh.name}, {"primitives", std::move(primitives)}});
  json["nodes"].push_back({{"name", mesh.name}, {"mesh", number}});
  json["scenes"][0]["nodes"].push_back(number);
}

ordered_json material_json(const GlbMaterial& material) {
  const std::array<float, 3>& c = material.base_colour;
  return {{"name", material.name},
          {"pbrMetallicRoughness",
           {{"baseColorFactor", {c[0], c[1], c[2], 1}},
            {"metallicFactor", 0},
            {"roughnessFactor", 0.6}}},
          {"emissiveFactor", material.emissive},
          {"doubleSided", true}};
}

}  // namespace

std::vector<std::byte> make_glb(std::span<const GlbMesh> meshes,
                                std::span<const GlbMaterial> materials) {
  GlbBuilder glb;
  for (const GlbMaterial& material : materials)
    glb.json["materials"].push_back(material_json(material));
  for (const GlbMesh& mesh : meshes) add_mesh(mesh, glb);
  return glb.file();
}

}  // namespace pelt::tools::output
