#include "self/self_track.hpp"

#include <pelt/self.hpp>

#include "base/bytes_held.hpp"

#include <algorithm>
#include <cmath>

namespace pelt {
namespace detail {
namespace {

/// Returns for each cluster the joint with the largest sum of weights over the vertices of its
/// node.
std::vector<std::uint16_t> find_anchors(const Tree& tree) {
  std::vector<std::uint16_t> anchors;
  std::vector<float> sums(tree.joint_count, 0.0f);
  for (const Node& node : tree.nodes) {
    std::fill(sums.begin(), sums.end(), 0.0f);
    for (std::uint32_t v = 0; v < node.vertex_count; ++v) {
      const std::uint32_t place = node.first_vertex + v;
      for (std::uint32_t k = tree.influence_begin[place]; k < tree.influence_begin[place + 1]; ++k)
        sums[tree.joints[k]] += tree.weights[k];
    }
    const auto most = std::max_element(sums.begin(), sums.end());
    anchors.insert(anchors.end(), node.cluster_count,
                   static_cast<std::uint16_t>(most - sums.begin()));
  }
  return anchors;
}

/// Returns the number of the cluster of each triangle, by place.
std::vector<std::uint32_t> clusters_of_places(const Tree& tree) {
  std::vector<std::uint32_t> clusters;
  for (std::uint32_t c = 0; c < tree.clusters.size(); ++c)
    clusters.insert(clusters.end(), tree.clusters[c].triangle_count, c);
  return clusters;
}

SelfTrack::Views find_views(const SelfFilter& filter, const std::vector<std::uint32_t>& clusters) {
  SelfTrack::Views views;
  const PairMasks& masks = filter.masks;
  const Tree& tree = filter.tree();
  for (std::uint32_t c = 0; c < tree.clusters.size(); ++c)
    for (std::uint32_t i = masks.begin[c]; i < masks.begin[c + 1]; ++i)
      views.push_back({c, masks.others[i]});
  for (std::uint32_t fan = 0; fan < filter.fans.flat_count(); ++fan)
    for (const FanTriangle& t : filter.fans[fan])
      views.push_back({clusters[filter.fans[fan][0].place()], clusters[t.place()]});
  std::sort(views.begin(), views.end());
  views.erase(std::unique(views.begin(), views.end()), views.end());
  return views;
}

struct Matrix3 {
  double m[3][3];  // by row
};

double determinant(const Matrix3& a) {
  const auto& m = a.m;
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

Matrix3 linear_part(const Matrix4& joint) {
  Matrix3 a;
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 3; ++column)
      a.m[row][column] = double{joint.m[4 * column + row]};
  return a;
}

/// The cofactors of `a`, transposed: the inverse times the determinant.
Matrix3 adjugate(const Matrix3& a) {
  const auto& m = a.m;
  const auto minor = [&](int i, int j, int k, int l) {
    return m[i][k] * m[j][l] - m[i][l] * m[j][k];
  };
  return {{{minor(1, 2, 1, 2), -minor(0, 2, 1, 2), minor(0, 1, 1, 2)},
           {-minor(1, 2, 0, 2), minor(0, 2, 0, 2), -minor(0, 1, 0, 2)},
           {minor(1, 2, 0, 1), -minor(0, 2, 0, 1), minor(0, 1, 0, 1)}}};
}

/// Returns the Frobenius norm of A^T A - I, rounded up, or infinity if A mirrors.
float bend_of(const float (&m)[12]) {
  double squared = 0;
  Matrix3 a;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) a.m[j][i] = double{m[3 * i + j]};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      double product = i == j ? -1 : 0;
      for (std::size_t k = 0; k < 3; ++k) product += a.m[k][i] * a.m[k][j];
      squared += product * product;
    }
  if (!(determinant(a) > 0)) return HUGE_VALF;
  return static_cast<float>(std::sqrt(squared) * (1 + 1e-6) + 1e-12);
}

/// J' J^-1, or the identity where that is far from a rotation.
JointStep step_between(const Matrix4& from, const Matrix4& to) {
  const Matrix3 old = linear_part(from), now = linear_part(to), inverse = adjugate(old);
  const double scale = 1 / determinant(old);
  double all[12];
  for (std::size_t row = 0; row < 3; ++row) {
    all[9 + row] = double{to.m[12 + row]};
    for (std::size_t column = 0; column < 3; ++column) {
      double sum = 0;
      for (std::size_t k = 0; k < 3; ++k) sum += now.m[row][k] * inverse.m[k][column];
      all[3 * column + row] = sum * scale;
      all[9 + row] -= sum * scale * double{from.m[12 + column]};
    }
  }
  JointStep step;
  for (std::size_t i = 0; i < 12; ++i) {
    if (!(std::fabs(all[i]) < 1e30)) return {};
    step.columns[i] = static_cast<float>(all[i]);
  }
  step.bend = bend_of(step.columns);
  return step.bend < 0.5f ? step : JointStep();
}

}  // namespace

SelfTrack::SelfTrack(const pelt::SelfFilter& f) : filter(f) {
  const SelfFilter& shared = filter.detail();
  const Tree& tree = shared.tree();
  const std::vector<std::uint32_t> clusters = clusters_of_places(tree);
  write_moved(find_anchors(tree), find_views(shared, clusters));
  for (std::uint32_t fan = 0; fan < shared.fans.flat_count(); ++fan)
    fan_clusters.push_back(clusters[shared.fans[fan][0].place()]);

  palette.resize(tree.joint_count);
  positions.resize(tree.rest_positions.size());
  pair_slack.resize(pair_motions.size());
  fan_slack.resize(fan_clusters.size());
  waits.resize(pair_motions.size());
  last_waits.resize(pair_motions.size());
  steps.resize(tree.joint_count);
  motions.resize(moved.size());
  cluster_motions.resize(tree.clusters.size());
}

void SelfTrack::write_moved(const std::vector<std::uint16_t>& anchors, const Views& views) {
  const auto packed = [&](std::uint32_t from, std::uint32_t seen) {
    return std::uint64_t{anchors[from]} << 32 | seen;
  };
  std::vector<std::uint64_t> sorted;
  for (const auto& [from, seen] : views) sorted.push_back(packed(from, seen));
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  for (const std::uint64_t one : sorted)
    moved.push_back({static_cast<std::uint32_t>(one), static_cast<std::uint16_t>(one >> 32)});
  const auto motion_of = [&](std::uint32_t from, std::uint32_t seen) {
    const auto found = std::lower_bound(sorted.begin(), sorted.end(), packed(from, seen));
    return static_cast<std::uint32_t>(found - sorted.begin());
  };

  const PairMasks& masks = filter.detail().masks;
  around_begin.assign(anchors.size() + 1, 0);
  for (const auto& [from, seen] : views) {
    around.push_back(motion_of(from, seen));
    ++around_begin[from + 1];
  }
  is_anchor.assign(filter.detail().tree().joint_count, 0);
  for (std::uint32_t c = 0; c < anchors.size(); ++c) {
    around_begin[c + 1] += around_begin[c];
    is_anchor[anchors[c]] = 1;
    own_motions.push_back(motion_of(c, c));
    for (std::uint32_t i = masks.begin[c]; i < masks.begin[c + 1]; ++i)
      pair_motions.push_back(motion_of(c, masks.others[i]));
  }
}

bool SelfTrack::begins_frame() {
  if (pause == 0) return true;
  if (--pause == 0) {
    has_frame = false;
    std::fill(pair_slack.begin(), pair_slack.end(), 0.0f);
    std::fill(fan_slack.begin(), fan_slack.end(), 0.0f);
  }
  return false;
}

void SelfTrack::pause_if_useless(std::size_t pairs_with_slack) {
  const bool is_useful = pairs_with_slack >= pair_slack.size() / 2;
  last_pause = is_useful ? 0 : longer(last_pause);
  pause = last_pause;
}

void SelfTrack::step_to(std::span<const Matrix4> next) {
  for (std::size_t j = 0; j < next.size(); ++j) {
    if (is_anchor[j]) steps[j] = step_between(palette[j], next[j]);
    palette[j] = next[j];
  }
}

std::size_t SelfTrack::memory_bytes() const {
  return sizeof(SelfTrack) +
         bytes_held(moved, around_begin, around, own_motions, pair_motions, fan_clusters, is_anchor,
                    palette) +
         bytes_held(positions, pair_slack, fan_slack, waits, last_waits, steps, motions,
                    cluster_motions);
}

}  // namespace detail

SelfTracker::SelfTracker(const SelfFilter& filter)
    : track_(std::make_unique<detail::SelfTrack>(filter)) {}
SelfTracker::SelfTracker(SelfTracker&&) noexcept = default;
SelfTracker& SelfTracker::operator=(SelfTracker&&) noexcept = default;
SelfTracker::~SelfTracker() = default;

const SelfFilter& SelfTracker::filter() const { return track_->filter; }
std::size_t SelfTracker::memory_bytes() const { return track_->memory_bytes(); }

}  // namespace pelt
