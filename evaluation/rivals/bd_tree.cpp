#include "evaluation/rivals/bd_tree.hpp"

#include "base/vec3.hpp"
#include "paper/leaf_order.hpp"
#include "paper/refit.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace pelt::rivals {

namespace {

using detail::Influence;
using detail::SkinnedMesh;
using detail::Vec3d;

float rounded_up(double value) { return static_cast<float>(value * (1 + 0x1p-20)); }

class Builder {
 public:
  Builder(const SkinnedMesh& mesh, const paper::SphereTree& tree, BdRecords& records)
      : mesh_(mesh),
        tree_(tree),
        records_(records),
        seen_in_(mesh.vertex_count(), 0),
        weight_of_(mesh.joint_count, 0),
        term_of_(mesh.joint_count, 0) {}

  void build() {
    for (std::uint32_t v = 0; v < mesh_.vertex_count(); ++v)
      records_.max_influences = std::max(records_.max_influences,
                                         static_cast<std::uint32_t>(mesh_.influences_of(v).size()));
    records_.first_term.push_back(0);
    for (const paper::Node& node : tree_.nodes) {
      collect(node);
      const std::uint16_t base = heaviest_joint();
      records_.base.push_back(base);
      append_terms(base);
      measure(Vec3d(node.rest.centre));
      for (const std::uint16_t joint : joints_) weight_of_[joint] = 0;
      records_.first_term.push_back(static_cast<std::uint32_t>(records_.terms.size()));
    }
  }

 private:
  /// Collects the vertices below a node, the joints that move them, and the sums of these joints'
  /// weights.
  void collect(const paper::Node& node) {
    vertices_.clear();
    joints_.clear();
    ++stamp_;
    for (const std::uint32_t t : tree_.triangles_of(node))
      for (const std::uint32_t v : mesh_.triangles[t])
        if (seen_in_[v] != stamp_) {
          seen_in_[v] = stamp_;
          vertices_.push_back(v);
        }
    for (const std::uint32_t v : vertices_)
      for (const Influence& influence : mesh_.influences_of(v)) {
        double& weight = weight_of_[influence.joint];
        if (weight == 0) joints_.push_back(static_cast<std::uint16_t>(influence.joint));
        weight += double{influence.weight};
      }
    std::sort(joints_.begin(), joints_.end());
  }

  std::uint16_t heaviest_joint() const {
    return *std::max_element(joints_.begin(), joints_.end(), [&](std::uint16_t a, std::uint16_t b) {
      return weight_of_[a] < weight_of_[b];
    });
  }

  void append_terms(std::uint16_t base) {
    for (const std::uint16_t joint : joints_) {
      if (joint == base) continue;
      term_of_[joint] = static_cast<std::uint32_t>(records_.terms.size());
      BdTerm term;
      term.joint = joint;
      term.pair = number_of_pair(joint, base);
      records_.terms.push_back(term);
    }
  }

  std::uint32_t number_of_pair(std::uint16_t joint, std::uint16_t base) {
    const auto number = static_cast<std::uint32_t>(records_.pairs.size());
    const auto [entry, is_new] = numbers_.emplace(std::pair(joint, base), number);
    if (is_new) records_.pairs.emplace_back(joint, base);
    return entry->second;
  }

  /// Calls `visit(term, w_ij, x_i)` for each vertex and each joint that moves it, except the base.
  template <typename Visit>
  void visit_influences(const Vec3d& centre, const Visit& visit) {
    for (const std::uint32_t v : vertices_) {
      const Vec3d x = Vec3d(mesh_.rest_positions[v]) - centre;
      for (const Influence& influence : mesh_.influences_of(v))
        if (influence.joint != records_.base.back())
          visit(term_of_[influence.joint] - records_.first_term.back(), double{influence.weight},
                x);
    }
  }

  /// Computes the means and deviations of the terms that were just appended.
  void measure(const Vec3d& centre) {
    const std::span<BdTerm> terms = std::span(records_.terms).subspan(records_.first_term.back());
    sums_.assign(terms.size(), {});
    visit_influences(centre, [&](std::uint32_t term, double w, const Vec3d& x) {
      sums_[term] = {sums_[term].wx + w * x, sums_[term].w + w, sums_[term].count + 1};
    });
    const double share = 1 / static_cast<double>(vertices_.size());
    std::vector<Deviation> largest(terms.size());
    for (std::size_t i = 0; i < terms.size(); ++i) {
      terms[i].mean_x = to_float(share * sums_[i].wx);
      terms[i].mean_w = static_cast<float>(share * sums_[i].w);
      // Vertices that the joint does not move have y_ij = 0.
      if (sums_[i].count < vertices_.size()) largest[i].include(terms[i], 0, {});
    }
    visit_influences(centre, [&](std::uint32_t term, double w, const Vec3d& x) {
      largest[term].include(terms[term], w, x);
    });
    for (std::size_t i = 0; i < terms.size(); ++i) {
      terms[i].deviation_x = rounded_up(std::sqrt(largest[i].squared_x));
      terms[i].deviation_w = rounded_up(largest[i].w);
    }
  }

  struct Sum {
    Vec3d wx;
    double w = 0;
    std::size_t count = 0;
  };

  struct Deviation {
    double squared_x = 0, w = 0;

    void include(const BdTerm& mean, double weight, const Vec3d& x) {
      squared_x = std::max(squared_x, squared_length(weight * x - Vec3d(mean.mean_x)));
      w = std::max(w, std::fabs(weight - double{mean.mean_w}));
    }
  };

  const SkinnedMesh& mesh_;
  const paper::SphereTree& tree_;
  BdRecords& records_;
  std::vector<std::uint32_t> seen_in_;  // by vertex: the last node that contained it
  std::uint32_t stamp_ = 0;
  std::vector<double> weight_of_;       // by joint, in the current node
  std::vector<std::uint32_t> term_of_;  // by joint, in the current node
  std::vector<std::uint32_t> vertices_;
  std::vector<std::uint16_t> joints_;
  std::vector<Sum> sums_;
  std::map<std::pair<std::uint16_t, std::uint16_t>, std::uint32_t> numbers_;
};

}  // namespace

BdRecords::BdRecords(const SkinnedMesh& mesh, const paper::SphereTree& tree) {
  Builder(mesh, tree, *this).build();
}

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

QueryStats collide(BdBody& a, const Palette& palette_a, BdBody& b, const Palette& palette_b,
                   paper::Scratch& scratch, std::vector<Contact>& contacts,
                   std::uint32_t max_contacts) {
  const std::uint64_t refits = a.refits() + b.refits();
  const std::uint64_t posed_vertices = a.posed_vertices() + b.posed_vertices();
  BdBody::Side side_a(a, palette_a), side_b(b, palette_b);
  QueryStats work = paper::descend(side_a, side_b, scratch, contacts, max_contacts);
  work.refits = a.refits() + b.refits() - refits;
  work.posed_vertices = a.posed_vertices() + b.posed_vertices() - posed_vertices;
  return work;
}

}  // namespace pelt::rivals
