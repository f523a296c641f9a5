#include "paper/refit.hpp"

#include "paper/prefetch.hpp"

#include <algorithm>
#include <cmath>

namespace pelt::paper {
namespace {

using detail::load4;

using Symmetric3 = std::array<std::array<double, 3>, 3>;

/// A^T A.
Symmetric3 gram(const Matrix4& joint) {
  Symmetric3 g;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = i; j < 3; ++j) {
      double sum = 0;
      for (std::size_t row = 0; row < 3; ++row)
        sum +=
            static_cast<double>(joint.m[4 * i + row]) * static_cast<double>(joint.m[4 * j + row]);
      g[i][j] = g[j][i] = sum;
    }
  return g;
}

Symmetric3 square(const Symmetric3& g) {
  Symmetric3 s;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      s[i][j] = g[i][0] * g[0][j] + g[i][1] * g[1][j] + g[i][2] * g[2][j];
  return s;
}

/// Gershgorin: no eigenvalue is larger.
double largest_row_sum(const Symmetric3& g) {
  double largest = 0;
  for (const auto& row : g)
    largest = std::max(largest, std::fabs(row[0]) + std::fabs(row[1]) + std::fabs(row[2]));
  return largest;
}

double largest_diagonal(const Symmetric3& g) { return std::max({g[0][0], g[1][1], g[2][2]}); }

/// Writes R_a = sum_j r_aj S_j for each corner of a joint set, adds them to `sum` and returns the
/// end of `r`. The number of joints is a template parameter if it is small, which is the usual
/// case.
template <std::uint32_t Joints>
Float4* blend(const Float4* s, const RecordedSet& set, Float4* r, Float4& sum) {
  const std::uint32_t n = Joints > 0 ? Joints : set.joint_count;
  const float* weight = set.corners;
  Float4 total = sum;
  for (Float4* const end = r + set.corner_count; r < end; ++r, weight += n) {
    Float4 blended = weight[0] * s[0];
    for (std::uint32_t j = 1; j < n; ++j) blended = blended + weight[j] * s[j];
    *r = blended;
    total = total + blended;
  }
  sum = total;
  return r;
}

Float4* blend_set(const Float4* s, const RecordedSet& set, Float4* r, Float4& sum) {
  switch (set.joint_count) {
    case 1:
      return blend<1>(s, set, r, sum);
    case 2:
      return blend<2>(s, set, r, sum);
    case 3:
      return blend<3>(s, set, r, sum);
    case 4:
      return blend<4>(s, set, r, sum);
    default:
      return blend<0>(s, set, r, sum);
  }
}

}  // namespace

float stretch_bound(const Matrix4& joint) {
  constexpr double kRounding = 1 + 0x1p-20;
  const Symmetric3 g = gram(joint);
  const double row_sum = largest_row_sum(g);
  // The largest eigenvalue lies between the two; for scale x rotation they are equal.
  if (row_sum <= largest_diagonal(g) * (1 + 0x1p-18))
    return static_cast<float>(std::sqrt(row_sum) * kRounding);
  Symmetric3 power = g;
  for (auto& row : power)
    for (double& entry : row) entry /= row_sum;
  constexpr int kSquarings = 3;
  for (int i = 0; i < kSquarings; ++i) power = square(power);
  double lambda = largest_row_sum(power);
  for (int i = 0; i < kSquarings; ++i) lambda = std::sqrt(lambda);
  return static_cast<float>(std::sqrt(row_sum * lambda) * kRounding);
}

Refit::Refit(const SphereModel& model, std::uint32_t joint_count)
    : model_(&model),
      joints_(joint_count),
      node_stamp_(model.tree.nodes.size(), 0),
      spheres_(model.tree.nodes.size()),
      joint_spheres_(model.bounds.max_joints),
      corner_spheres_(model.bounds.max_corners) {}

void Refit::invalidate() {
  if (++stamp_ != 0) return;
  std::fill(node_stamp_.begin(), node_stamp_.end(), 0);
  stamp_ = 1;
}

void Refit::take_palette(const Palette& palette) {
  for (std::uint32_t j = 0; j < joints_.size(); ++j) {
    const Matrix4& m = palette[j];
    for (std::size_t column = 0; column < 4; ++column)
      joints_[j].columns[column] = load4(m.m.data() + 4 * column);
    joints_[j].columns[3] = Float4(m.m[12], m.m[13], m.m[14], stretch_bound(m));
  }
  const auto n = static_cast<float>(model_->bounds.max_joints);
  margin_ = (4 * n + 32) * 0x1p-24f * palette.reach();
  palette_stamp_ = stamp_;
}

/// The descent reads these records if it opens the node, which it does after half of the refits.
void Refit::prefetch_children(const RefitRecord& record) const {
  model_->records.prefetch_children(record);
  prefetch(&node_stamp_[record.first_child]);
  prefetch(&spheres_[record.first_child]);
  prefetch(&model_->tree.nodes[record.first_child]);
  prefetch(&model_->tree.nodes[record.first_child] + 1);
}

/// Eq. 5: the spheres S_j = C_j S of each joint set, blended by each of its corners.
Refit::CornerSpheres Refit::blend_corners(RefitRecords::Reader& reader) {
  const Vec3& c = reader.record.rest.centre;
  const Float4 x(c.x), y(c.y), z(c.z);
  Float4* const s = joint_spheres_.data();
  Float4* r = corner_spheres_.data();
  Float4 sum(0.0f);
  for (std::uint32_t i = 0; i < reader.record.set_count; ++i) {
    const RecordedSet set = reader.next_set();
    for (std::uint32_t j = 0; j < set.joint_count; ++j) {
      const Float4* column = joints_[RefitRecords::as_number(set.joints[j])].columns;
      s[j] = (x * column[0] + z * column[2]) + (y * column[1] + column[3]);
    }
    r = blend_set(s, set, r, sum);
  }
  return {{corner_spheres_.data(), r}, sum};
}

/// The paper's approximate enclosing sphere: around the average of the corner spheres' centres.
void Refit::refit(std::uint32_t node, const Palette& palette) {
  if (palette_stamp_ != stamp_) take_palette(palette);
  RefitRecords::Reader reader = model_->records.of(node);
  prefetch_children(reader.record);
  const auto [corners, sum] = blend_corners(reader);
  const Float4 centre = (1 / static_cast<float>(corners.size())) * sum;

  float squared_reach = 0, stretch = 0;
  for (const Float4& r : corners) {
    squared_reach = std::max(squared_reach, squared_distance(r, centre));
    stretch = std::max(stretch, r[3]);
  }
  const float radius = std::sqrt(squared_reach) + reader.record.rest.radius * stretch + margin_;
  spheres_[node] = make_ball(centre, radius);
  node_stamp_[node] = stamp_;
  ++refits_;
}

}  // namespace pelt::paper
