#include "asset/morph_merge.hpp"

#include "asset/message.hpp"

namespace pelt::asset {

MorphMerge::MorphMerge(const GltfDocument& document, const NodeGraph& graph,
                       PrimitiveReader& primitives, Budget& budget, Asset& asset)
    : document_(document), graph_(graph), primitives_(primitives), budget_(budget), asset_(asset) {}

void MorphMerge::begin_node(std::uint32_t node, std::uint32_t mesh) {
  node_ = node;
  mesh_ = mesh;
  targets_.assign(document_.meshes[mesh].target_count(), {});
}

Result<void> MorphMerge::add_vertices(PrimitivePlace place, std::uint32_t first,
                                      std::size_t count) {
  for (std::uint32_t t = 0; t < targets_.size(); ++t) {
    const Result<std::vector<Vec3>> displacements = primitives_.displacements(place, t, count);
    if (!displacements) return displacements.error();
    // Counted twice: here and in the asset.
    const Result<void> taken = budget_.take(displacements->size(), 2 * (sizeof(Vec3) + 4),
                                            primitive_label(document_, place) + ", morph targets");
    if (!taken) return taken.error();
    for (std::uint32_t v = 0; v < displacements->size(); ++v) {
      if ((*displacements)[v] == Vec3()) continue;
      targets_[t].vertices.push_back(first + v);
      targets_[t].displacements.push_back((*displacements)[v]);
    }
  }
  return {};
}

Result<void> MorphMerge::end_node() {
  if (targets_.empty()) return {};
  std::size_t name_bytes = 0;
  for (const std::string& name : document_.meshes[mesh_].target_names) name_bytes += name.size();
  const Result<void> taken =
      budget_.take(targets_.size() * (sizeof(MorphTarget) + sizeof(Displaced) + 4) + name_bytes, 1,
                   node_label(document_, node_) + ", morph targets");
  if (!taken) return taken.error();
  if (asset_.morph_begin.empty()) asset_.morph_begin.push_back(0);
  for (std::size_t t = 0; t < targets_.size(); ++t) append(t);
  return {};
}

void MorphMerge::append(std::size_t target) {
  const GltfMesh& mesh = document_.meshes[mesh_];
  const std::vector<float>& own = document_.nodes[node_].weights;
  const std::vector<float>& weights = own.empty() ? mesh.weights : own;
  MorphTarget described;
  described.node = graph_.position[node_];
  if (target < mesh.target_names.size()) described.name = mesh.target_names[target];
  if (target < weights.size()) described.default_weight = weights[target];
  asset_.morph_targets.push_back(std::move(described));
  const Displaced& displaced = targets_[target];
  asset_.morph_vertices.insert(asset_.morph_vertices.end(), displaced.vertices.begin(),
                               displaced.vertices.end());
  asset_.morph_displacements.insert(asset_.morph_displacements.end(),
                                    displaced.displacements.begin(), displaced.displacements.end());
  asset_.morph_begin.push_back(static_cast<std::uint32_t>(asset_.morph_vertices.size()));
}

}  // namespace pelt::asset
