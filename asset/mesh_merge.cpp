#include "asset/mesh_merge.hpp"

#include "asset/joint_table.hpp"
#include "asset/node_graph.hpp"
#include "asset/primitive.hpp"
#include "text/message.hpp"

#include <algorithm>

namespace pelt::asset {
namespace {

/// Traverses the scene once and appends its meshes to the asset.
class Merger {
 public:
  Merger(const GltfDocument& document, const NodeGraph& graph, AccessorReader& reader,
         Budget& budget, Asset& asset);

  Result<void> add_node(std::uint32_t node);
  Result<void> finish();

 private:
  Result<void> add_primitive(std::uint32_t node, PrimitivePlace place);
  Result<std::uint32_t> vertices(std::uint32_t node, PrimitivePlace place);
  Result<std::uint32_t> add_vertices(std::uint32_t node, PrimitivePlace place);
  Result<Influences> influences(std::uint32_t node, PrimitivePlace place, std::size_t vertex_count);
  Result<Influences> rigid_influences(std::uint32_t node, std::size_t vertex_count);
  Result<void> add_part(std::uint32_t node, PrimitivePlace place, std::size_t triangle_count);
  const std::vector<std::uint32_t>& drawn_primitives(std::uint32_t mesh);
  bool is_drawn(PrimitivePlace place);

  const GltfDocument& document_;
  Budget& budget_;
  Asset& asset_;
  JointTable joints_;
  PrimitiveReader primitives_;
  MorphMerge morphs_;
  Influences influences_;  ///< of all vertices so far
  std::map<std::uint32_t, std::vector<std::uint32_t>> drawn_;
  /// First vertex of each combination of accessors that the current node has used: primitives that
  /// share vertices in the file share them here.
  std::map<std::vector<std::uint32_t>, std::uint32_t> shared_;
};

/// Identifies a primitive's vertices; equal for primitives that share them.
std::vector<std::uint32_t> vertex_key(const GltfPrimitive& primitive) {
  std::vector<std::uint32_t> key = {*primitive.positions};
  for (const GltfInfluenceSet& set : primitive.influence_sets) {
    key.insert(key.end(), {set.joints, set.weights});
  }
  for (const std::optional<std::uint32_t>& target : primitive.target_positions) {
    key.insert(key.end(), {target.has_value(), target.value_or(0)});
  }
  return key;
}

Merger::Merger(const GltfDocument& document, const NodeGraph& graph, AccessorReader& reader,
               Budget& budget, Asset& asset)
    : document_(document),
      budget_(budget),
      asset_(asset),
      joints_(document, graph, reader),
      primitives_(document, reader, budget),
      morphs_(document, graph, primitives_, budget, asset) {}

Result<void> Merger::add_node(std::uint32_t node) {
  const std::uint32_t mesh = *document_.nodes[node].mesh;
  shared_.clear();
  morphs_.begin_node(node, mesh);
  for (const std::uint32_t primitive : drawn_primitives(mesh)) {
    const Result<void> added = add_primitive(node, {mesh, primitive});
    if (!added) return text::prefixed(node_label(document_, node), added.error());
  }
  return morphs_.end_node();
}

Result<void> Merger::add_primitive(std::uint32_t node, PrimitivePlace place) {
  const Result<std::uint32_t> first = vertices(node, place);
  if (!first) return first.error();
  const std::size_t vertex_count =
      document_.accessors[*document_.meshes[place.mesh].primitives[place.primitive].positions]
          .count;
  const Result<std::vector<Triangle>> triangles = primitives_.triangles(place, vertex_count);
  if (!triangles) return triangles.error();
  const Result<void> part = add_part(node, place, triangles->size());
  if (!part) return part.error();
  for (const Triangle& triangle : *triangles) {
    asset_.triangles.push_back({triangle[0] + *first, triangle[1] + *first, triangle[2] + *first});
  }
  return {};
}

/// Returns the first of the primitive's vertices. Adds them unless another primitive shares them.
Result<std::uint32_t> Merger::vertices(std::uint32_t node, PrimitivePlace place) {
  const GltfPrimitive& primitive = document_.meshes[place.mesh].primitives[place.primitive];
  const std::vector<std::uint32_t> key = vertex_key(primitive);
  const auto known = shared_.find(key);
  if (known != shared_.end()) return known->second;
  const Result<std::uint32_t> first = add_vertices(node, place);
  if (first) shared_[key] = *first;
  return first;
}

Result<std::uint32_t> Merger::add_vertices(std::uint32_t node, PrimitivePlace place) {
  const Result<std::vector<Vec3>> positions = primitives_.positions(place);
  if (!positions) return positions.error();
  const Result<Influences> influences = this->influences(node, place, positions->size());
  if (!influences) return influences.error();
  const Result<void> taken = budget_.take(positions->size() + influences->list.size(), 20,
                                          primitive_label(document_, place));
  if (!taken) return taken.error();
  const auto first = static_cast<std::uint32_t>(asset_.rest_positions.size());
  asset_.rest_positions.insert(asset_.rest_positions.end(), positions->begin(), positions->end());
  const std::uint64_t offset = influences_.list.size();
  for (std::size_t v = 1; v < influences->first.size(); ++v) {
    influences_.first.push_back(offset + influences->first[v]);
  }
  influences_.list.insert(influences_.list.end(), influences->list.begin(), influences->list.end());
  const Result<void> morphed = morphs_.add_vertices(place, first, positions->size());
  if (!morphed) return morphed.error();
  return first;
}

Result<Influences> Merger::influences(std::uint32_t node, PrimitivePlace place,
                                      std::size_t vertex_count) {
  const std::optional<std::uint32_t> skin = document_.nodes[node].skin;
  if (!skin) return rigid_influences(node, vertex_count);
  const Result<const std::vector<std::uint16_t>*> joints = joints_.add_skin(*skin);
  if (!joints) return joints.error();
  return primitives_.influences(place, **joints, skin_label(document_, *skin));
}

/// Returns the influences of a mesh without a skin, which follows its node as a single joint.
Result<Influences> Merger::rigid_influences(std::uint32_t node, std::size_t vertex_count) {
  const Result<std::uint16_t> joint = joints_.add_node(node);
  if (!joint) return joint.error();
  Influences influences;
  influences.list.assign(vertex_count, {*joint, 1});
  for (std::size_t v = 0; v < vertex_count; ++v) influences.first.push_back(v + 1);
  return influences;
}

Result<void> Merger::add_part(std::uint32_t node, PrimitivePlace place,
                              std::size_t triangle_count) {
  const GltfMesh& mesh = document_.meshes[place.mesh];
  const std::optional<std::uint32_t> material = mesh.primitives[place.primitive].material;
  Part part;
  part.node = document_.nodes[node].name;
  part.mesh = mesh.name;
  if (material) part.material = document_.materials[*material];
  part.first_triangle = static_cast<std::uint32_t>(asset_.triangles.size());
  part.triangle_count = static_cast<std::uint32_t>(triangle_count);
  part.skinned = document_.nodes[node].skin.has_value();
  const std::uint64_t name_bytes = part.node.size() + part.mesh.size() + part.material.size();
  const std::uint64_t bytes = sizeof(Part) + name_bytes + triangle_count * sizeof(Triangle);
  const Result<void> taken = budget_.take(bytes, 1, primitive_label(document_, place));
  if (taken && triangle_count > 0) asset_.parts.push_back(std::move(part));
  return taken;
}

/// Returns the primitives of a mesh with triangles. Warns of the others, once per mesh.
const std::vector<std::uint32_t>& Merger::drawn_primitives(std::uint32_t mesh) {
  const auto known = drawn_.find(mesh);
  if (known != drawn_.end()) return known->second;
  std::vector<std::uint32_t>& drawn = drawn_[mesh];
  for (std::uint32_t i = 0; i < document_.meshes[mesh].primitives.size(); ++i) {
    if (is_drawn({mesh, i})) drawn.push_back(i);
  }
  return drawn;
}

bool Merger::is_drawn(PrimitivePlace place) {
  const GltfPrimitive& primitive = document_.meshes[place.mesh].primitives[place.primitive];
  const bool points_or_lines = primitive.mode == PrimitiveMode::points_or_lines;
  if (!points_or_lines && primitive.positions) return true;
  asset_.warnings.push_back(primitive_label(document_, place) + " is ignored: it has " +
                            (points_or_lines ? "points or lines" : "no POSITION"));
  return false;
}

/// Gives every vertex the same number of influences, the largest number of any vertex.
Result<void> Merger::finish() {
  const std::size_t vertex_count = asset_.rest_positions.size();
  std::uint64_t most = 1;
  for (std::size_t v = 0; v < vertex_count; ++v) {
    most = std::max(most, influences_.first[v + 1] - influences_.first[v]);
  }
  const Result<void> taken = budget_.take(vertex_count * most, 6, "influences");
  if (!taken) return taken.error();
  asset_.influences_per_vertex = static_cast<std::uint32_t>(most);
  asset_.joint_indices.assign(vertex_count * most, 0);
  asset_.weights.assign(vertex_count * most, 0);
  for (std::size_t v = 0; v < vertex_count; ++v) {
    std::uint64_t slot = v * most;
    for (std::uint64_t i = influences_.first[v]; i < influences_.first[v + 1]; ++i, ++slot) {
      asset_.joint_indices[slot] = influences_.list[i].joint;
      asset_.weights[slot] = influences_.list[i].weight;
    }
  }
  asset_.joints = std::move(joints_).take();
  return {};
}

}  // namespace

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

Result<void> merge_meshes(const GltfDocument& document, const NodeGraph& graph,
                          const GltfOptions& options, AccessorReader& reader, Budget& budget,
                          Asset& asset) {
  const Result<std::vector<std::uint32_t>> nodes = choose_mesh_nodes(document, graph, options);
  if (!nodes) return nodes.error();
  Merger merger(document, graph, reader, budget, asset);
  for (const std::uint32_t node : *nodes) {
    const Result<void> added = merger.add_node(node);
    if (!added) return added.error();
  }
  if (asset.triangles.empty())
    return text::unsupported(
        "the scene has no triangles: export its meshes, and exclude fewer of them");
  return merger.finish();
}

}  // namespace pelt::asset
