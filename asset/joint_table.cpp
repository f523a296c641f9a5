#include "asset/joint_table.hpp"
#include "asset/transform.hpp"
#include "base/bits.hpp"
#include "text/message.hpp"

#include <algorithm>

namespace pelt::asset {

std::string skin_label(const GltfDocument& document, std::uint32_t skin) {
  return text::label("skin", skin, document.skins[skin].name);
}

JointTable::JointTable(const GltfDocument& document, const NodeGraph& graph, AccessorReader& reader)
    : document_(document), graph_(graph), reader_(reader) {}

Result<const std::vector<std::uint16_t>*> JointTable::add_skin(std::uint32_t skin) {
  const auto known = skins_.find(skin);
  if (known != skins_.end()) return &known->second;
  const Result<std::vector<Matrix4>> matrices = inverse_binds(skin);
  if (!matrices) return matrices.error();
  std::vector<std::uint16_t> numbers;
  const std::vector<std::uint32_t>& nodes = document_.skins[skin].joints;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Result<std::uint16_t> number = add(nodes[i], (*matrices)[i]);
    if (!number) return text::prefixed(skin_label(document_, skin), number.error());
    numbers.push_back(*number);
  }
  return &(skins_[skin] = std::move(numbers));
}

Result<std::uint16_t> JointTable::add_node(std::uint32_t node) { return add(node, Matrix4{}); }

Result<std::uint16_t> JointTable::add(std::uint32_t node, const Matrix4& inverse_bind) {
  constexpr std::size_t kMax = 65535;
  const auto key = std::make_pair(node, detail::bits_as<Bits>(inverse_bind.m));
  const auto known = known_.find(key);
  if (known != known_.end()) return known->second;
  if (joints_.size() == kMax) {
    return text::unsupported(node_label(document_, node) + ": the file needs more than " +
                             std::to_string(kMax) +
                             " joints: export its characters to several files");
  }
  const auto number = static_cast<std::uint16_t>(joints_.size());
  joints_.push_back({graph_.position[node], inverse_bind});
  known_.emplace(key, number);
  return number;
}

/// Returns one matrix per joint of the skin; the identity if the file has none.
Result<std::vector<Matrix4>> JointTable::inverse_binds(std::uint32_t index) {
  const GltfSkin& skin = document_.skins[index];
  std::vector<Matrix4> matrices(skin.joints.size());
  if (!skin.inverse_bind_matrices) return matrices;
  const std::string use = "inverseBindMatrices of " + skin_label(document_, index);
  const std::string what = accessor_label(*skin.inverse_bind_matrices, use);
  const Result<std::vector<float>> values =
      reader_.floats(*skin.inverse_bind_matrices, ElementType::mat4, Storage::floats, use);
  if (!values) return values.error();
  if (values->size() < 16 * matrices.size()) {
    return text::malformed(what + ": " + std::to_string(values->size() / 16) + " matrices for " +
                           std::to_string(matrices.size()) + " joints");
  }
  for (std::size_t i = 0; i < matrices.size(); ++i) {
    std::copy_n(values->begin() + static_cast<std::ptrdiff_t>(16 * i), 16, matrices[i].m.begin());
    if (!make_affine(matrices[i])) {
      return text::malformed(what + ": the last row of matrix " + std::to_string(i) +
                             " must be 0 0 0 1");
    }
  }
  return matrices;
}

}  // namespace pelt::asset
