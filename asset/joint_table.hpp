#pragma once

#include "asset/accessor.hpp"
#include "asset/node_graph.hpp"

#include <map>

namespace pelt::asset {

/// The joints of all skins and unskinned parts that a file uses. Equal joints (the same node and
/// the same bits of the inverse bind matrix) are stored once.
class JointTable {
 public:
  /// Borrows all its arguments.
  JointTable(const GltfDocument& document, const NodeGraph& graph, AccessorReader& reader);

  /// Returns for each joint of the skin its number in the table. The reference stays valid.
  Result<const std::vector<std::uint16_t>*> add_skin(std::uint32_t skin);

  /// Returns the joint that moves like `node` (the document's number).
  Result<std::uint16_t> add_node(std::uint32_t node);

  std::vector<Joint> take() && { return std::move(joints_); }

 private:
  Result<std::uint16_t> add(std::uint32_t node, const Matrix4& inverse_bind);
  Result<std::vector<Matrix4>> inverse_binds(std::uint32_t skin);

  using Bits = std::array<std::uint32_t, 16>;

  const GltfDocument& document_;
  const NodeGraph& graph_;
  AccessorReader& reader_;
  std::vector<Joint> joints_;
  std::map<std::pair<std::uint32_t, Bits>, std::uint16_t> known_;
  std::map<std::uint32_t, std::vector<std::uint16_t>> skins_;
};

/// `skin 1 "Armature"`.
std::string skin_label(const GltfDocument& document, std::uint32_t skin);

}  // namespace pelt::asset
