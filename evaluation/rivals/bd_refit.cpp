#include "evaluation/rivals/bd_refit.hpp"

#include "paper/leaf_order.hpp"
#include "paper/refit.hpp"

#include <algorithm>
#include <cmath>

namespace pelt::rivals {
namespace {

/// The columns of a joint matrix.
struct Columns {
  explicit Columns(const Matrix4& matrix)
      : x(detail::load4(matrix.m.data())),
        y(detail::load4(matrix.m.data() + 4)),
        z(detail::load4(matrix.m.data() + 8)),
        t(detail::load4(matrix.m.data() + 12)) {}

  Float4 turn(const Vec3& v) const { return Float4(v.x) * x + Float4(v.z) * z + Float4(v.y) * y; }
  Float4 map(const Vec3& v) const {
    return (Float4(v.x) * x + Float4(v.z) * z) + (Float4(v.y) * y + t);
  }

  Float4 x, y, z, t;
};

Columns operator-(Columns a, const Columns& b) {
  a.x = a.x - b.x, a.y = a.y - b.y, a.z = a.z - b.z, a.t = a.t - b.t;
  return a;
}

Matrix4 difference(const Matrix4& a, const Matrix4& b) {
  Matrix4 d;
  for (std::size_t i = 0; i < 16; ++i) d.m[i] = a.m[i] - b.m[i];
  return d;
}

}  // namespace

BdModel::BdModel(const detail::SkinnedMesh& mesh)
    : tree(paper::build_sphere_tree(mesh.rest_positions, mesh.triangles)),
      records(mesh, tree),
      leaf_mesh(paper::in_leaf_order(mesh, tree)) {}

BdRefit::BdRefit(const BdModel& model, std::uint32_t joint_count)
    : model_(&model),
      node_stamp_(model.tree.nodes.size(), 0),
      spheres_(model.tree.nodes.size()),
      joint_norms_(joint_count),
      pair_norms_(model.records.pairs.size()) {}

void BdRefit::invalidate() {
  if (++stamp_ != 0) return;
  std::fill(node_stamp_.begin(), node_stamp_.end(), 0);
  std::fill(joint_norms_.begin(), joint_norms_.end(), Norm{});
  std::fill(pair_norms_.begin(), pair_norms_.end(), Norm{});
  stamp_ = 1;
}

float BdRefit::norm_of_joint(std::uint32_t joint, const Palette& palette) {
  Norm& norm = joint_norms_[joint];
  if (norm.stamp != stamp_) norm = {paper::stretch_bound(palette[joint]), stamp_};
  return norm.value;
}

float BdRefit::norm_of_pair(std::uint32_t pair, const Palette& palette) {
  Norm& norm = pair_norms_[pair];
  const auto [joint, base] = model_->records.pairs[pair];
  if (norm.stamp != stamp_)
    norm = {paper::stretch_bound(difference(palette[joint], palette[base])), stamp_};
  return norm.value;
}

void BdRefit::refit(std::uint32_t node, const Palette& palette) {
  const BdRecords& records = model_->records;
  const paper::Sphere& rest = model_->tree.nodes[node].rest;
  const Columns base(palette[records.base[node]]);
  const Float4 base_point = base.map(rest.centre);
  Float4 centre = base_point;
  float radius = norm_of_joint(records.base[node], palette) * rest.radius;
  const std::uint32_t begin = records.first_term[node], end = records.first_term[node + 1];
  for (std::uint32_t i = begin; i < end; ++i) {
    const BdTerm& term = records.terms[i];
    const Columns joint(palette[term.joint]);
    const Float4 apart = joint.map(rest.centre) - base_point;
    centre = centre + ((joint - base).turn(term.mean_x) + Float4(term.mean_w) * apart);
    const float distance = std::sqrt(paper::squared_distance(apart, Float4(0.0f)));
    radius += norm_of_pair(term.pair, palette) * term.deviation_x + distance * term.deviation_w;
  }
  const auto m = static_cast<float>(end - begin), n = static_cast<float>(records.max_influences);
  const float margin = (24 * m + 4 * n + 48) * 0x1p-24f * palette.reach();
  spheres_[node] = paper::make_ball(centre, radius * (1 + 0x1p-22f * (m + 4)) + margin);
  node_stamp_[node] = stamp_;
  ++refits_;
}

}  // namespace pelt::rivals
