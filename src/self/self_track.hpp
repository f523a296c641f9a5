#pragma once

/// The state that a pelt::SelfTracker keeps from one frame to the next. If two triangles were apart
/// and their surroundings have hardly bent since, then they are still apart.
///
/// Motion. Let R be any rotation with a translation, and let |v' - R v| <= m for all vertices v of
/// some triangles, where v becomes v' in the next frame. A point of a triangle is a convex
/// combination of its vertices. If x' has the same weights as x, then |x' - R x| <= m, too.
///
/// R is chosen from the matrices J and then J' of the joint that moves most of a node (the anchor
/// of its clusters). Let J' J^-1 = (A | b), and A = Q P with a rotation Q and P positive
/// semidefinite, which requires det A > 0. The singular values s of A satisfy |s - 1| <= |s^2 - 1|.
/// Therefore |P - I| <= |A^T A - I| <= bend, where bend is the Frobenius norm, rounded up. With R =
/// (Q | b), |R v - (A v + b)| = |(I - P) v| <= bend |v|, so
///
///     m <= max |v' - (A v + b)| + bend max |v|
///
/// Where det A <= 0, bend >= 0.5 or J has no inverse, (A | b) is the identity instead. The bound
/// holds for every (A | b); one that fits badly only makes m large.
///
/// Slack of clusters. Let g be a lower bound of the distance of all pairs of triangles of two
/// clusters, apart from the pairs that share a surface vertex. Let m_a and m_b be their motions
/// relative to one R, that of the first cluster's anchor. R changes no distance, so g - m_a - m_b
/// is a lower bound in the next frame, and takes the place of g. While it is positive, no pair
/// needs a test. Two clusters with hubs never have slack, because their masks are incomplete.
///
/// Slack of fans. Let m be the largest motion of the clusters with triangles of a certified fan,
/// all relative to the R of the anchor of the first triangle's cluster. The certificate
/// (flat_fans.cpp) demands several determinants det(n, e_i, e_j) of spokes to be at least d |n|.
/// Turn n by R, which changes no determinant. A spoke differs from the turned one by at most 2 m,
/// because both of its ends move by at most m relative to R. With L the longest spoke, a
/// determinant changes by at most |n| (2 L 2 m + (2 m)^2). This is less than d |n| exactly if m is
/// less than the slack (sqrt(L^2 + d) - L) / 2. Until then the fan remains certified. In further
/// frames, motions add.

#include <pelt/self.hpp>

#include "base/instruction_set.hpp"
#include "pose/posed_tree.hpp"
#include "self/self_filter.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace pelt::detail {

/// (A | b) with its `bend`.
struct JointStep {
  float columns[12] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
  float bend = 0;
};

struct SelfTrack {
  explicit SelfTrack(const pelt::SelfFilter& f);

  pelt::SelfFilter filter;

  /// A motion to measure: that of `cluster` relative to the step of the joint `anchor`, which is
  /// the anchor of this cluster or of a neighbour.
  struct Moved {
    std::uint32_t cluster;
    std::uint16_t anchor;
  };

  // Arrays of motions [N], clusters [C], closed and open fans [F], joints [J]. Arrays of pairs are
  // in the order of PairMasks::masks.
  std::vector<Moved> moved;                 // [N] sorted by anchor
  std::vector<std::uint32_t> own_motions;   // [C] the motion relative to its own anchor
  std::vector<std::uint32_t> pair_motions;  // of the second cluster
  // The motions relative to a cluster's anchor: of itself, its neighbours with higher numbers, and
  // the clusters of the fans that begin in it.
  std::vector<std::uint32_t> around_begin;  // [C + 1] into around
  std::vector<std::uint32_t> around;
  std::vector<std::uint32_t> fan_clusters;  // [F] cluster of the first triangle
  std::vector<std::uint8_t> is_anchor;      // [J]

  // The last frame.
  bool has_frame = false;
  float extent = 0;                             // no coordinate is larger
  std::vector<Matrix4> palette;                 // [J]
  std::vector<std::array<float, 4>> positions;  // by place
  std::vector<float> pair_slack;
  std::vector<float> fan_slack;                 // [F]
  std::vector<std::uint8_t> waits, last_waits;  // of pairs, in frames
  std::uint8_t pause = 0, last_pause = 0;       // frames

  // Working memory.
  std::vector<JointStep> steps;        // [J] only of anchors
  std::vector<float> motions;          // [N]
  std::vector<float> cluster_motions;  // [C] largest of `around`

  /// Returns whether to measure the distance of a pair without slack. Otherwise counts down the
  /// frames in which the pair is only tested.
  bool may_gain(std::uint32_t pair) {
    if (waits.data()[pair] == 0) return true;
    --waits.data()[pair];
    return false;
  }

  /// Sets the slack of a pair; `cluster` is the first of the pair. If the motion of this frame is
  /// not smaller than the new slack, the pair is only tested in the next 7 frames, then 15, 31, 63
  /// and 127, because a test costs less than a measurement.
  void set_slack(std::uint32_t cluster, std::uint32_t pair, float slack) {
    const float motion =
        motions.data()[own_motions.data()[cluster]] + motions.data()[pair_motions.data()[pair]];
    pair_slack.data()[pair] = slack;
    std::uint8_t& last = last_waits.data()[pair];
    last = slack > motion ? 0 : longer(last);
    waits.data()[pair] = last;
  }

  /// Returns false in a paused frame, in which nothing is remembered.
  bool begins_frame();

  /// Call after the slack was reduced. If less than half of the pairs have slack, the tracker
  /// pauses in the next 7, 15, 31, 63 or 127 frames: a body that moves fast, or whose layers touch
  /// everywhere, gains nothing.
  void pause_if_useless(std::size_t pairs_with_slack);

  /// Writes `steps` from the last frame to this palette, and keeps the palette.
  void step_to(std::span<const Matrix4> next);

  std::size_t memory_bytes() const;

  /// Pairs (c, d): the motion of cluster d is measured relative to the anchor of cluster c. Sorted.
  using Views = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

 private:
  static std::uint8_t longer(std::uint8_t wait) {
    constexpr int kFirst = 7, kMost = 127;
    return static_cast<std::uint8_t>(wait == 0 ? kFirst : wait < kMost ? 2 * wait + 1 : kMost);
  }
  void write_moved(const std::vector<std::uint16_t>& anchors, const Views& views);
};

inline namespace PELT_INSTRUCTION_SET {

/// Copies the posed vertices of all pools to one array, by place. Precondition: all nodes are open.
void write_positions(const PosedTree& posed, std::array<float, 4>* positions);

/// Begins a frame: writes the posed vertices and their largest coordinate to `track`, and reduces
/// all slack by the motion since the last frame (see self_track.hpp). Precondition: all nodes are
/// open.
void begin_frame(const PosedTree& posed, SelfTrack& track, QueryStats& work);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
