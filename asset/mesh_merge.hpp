#pragma once

/// Merges the primitives of a file to one mesh.

#include "asset/accessor.hpp"
#include "asset/node_graph.hpp"
#include "asset/primitive.hpp"

namespace pelt::asset {

/// Appends the morph targets of meshes to the asset, node by node.
class MorphMerge {
 public:
  /// Borrows all its arguments.
  MorphMerge(const GltfDocument& document, const NodeGraph& graph, PrimitiveReader& primitives,
             Budget& budget, Asset& asset);

  void begin_node(std::uint32_t node, std::uint32_t mesh);

  /// Adds the displacements of a primitive's vertices, which start at `first` in the asset.
  Result<void> add_vertices(PrimitivePlace place, std::uint32_t first, std::size_t count);

  Result<void> end_node();

 private:
  /// Displacements of one target in all primitives of the node's mesh.
  struct Displaced {
    std::vector<std::uint32_t> vertices;
    std::vector<Vec3> displacements;
  };

  void append(std::size_t target);

  const GltfDocument& document_;
  const NodeGraph& graph_;
  PrimitiveReader& primitives_;
  Budget& budget_;
  Asset& asset_;
  std::uint32_t node_ = 0, mesh_ = 0;  // the current node and mesh
  std::vector<Displaced> targets_;
};

/// Merges the meshes of the scene into one: fills `asset` except for its nodes and clips.
Result<void> merge_meshes(const GltfDocument& document, const NodeGraph& graph,
                          const GltfOptions& options, AccessorReader& reader, Budget& budget,
                          Asset& asset);

}  // namespace pelt::asset
