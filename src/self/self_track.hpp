#pragma once

/// What a pelt::SelfTracker remembers from one frame to the next. If two triangles were apart and
/// their surroundings have hardly bent since, then they are still apart.
///
/// Motion. Let R be any isometry, and let |v' - R v| <= m for all vertices of some triangles, where
/// v becomes v' in the next frame. Points of a triangle are convex combinations of its vertices, so
/// the same holds for all points x and x' of the triangles. R is chosen from the joint matrices, C
/// and then C', of the joint that moves most of a cluster's node (its anchor): C' C^-1 = (A | b).
/// Let A = Q P with a rotation Q and P positive semidefinite. The singular values s of A satisfy |s
/// - 1| <= |s^2 - 1|, so |P - I| <= |A^T A - I| = bend, and R = (Q | b) differs from (A | b) by at
/// most bend |x|. The bound holds for any (A | b); a bad one only makes m large.
///
/// Slack of clusters. Let g be a lower bound of the distance of all pairs of triangles of two
/// clusters, apart from the pairs that share a surface vertex. If the clusters move by at most m_a
/// and m_b beside R, then g - m_a - m_b is a lower bound in the next frame, because R changes no
/// distance. While it is positive, no pair needs a test.
///
/// Slack of fans. In a certified fan (flat_fans.cpp), certain determinants det(n, e_i, e_j) of
/// spokes are at least d |n|. Turn n by R. A spoke differs from the turned one by at most 2 m,
/// because both of its ends move by at most m beside R. With L the longest spoke, the determinants
/// change by at most |n| (2 L 2 m + (2 m)^2). They keep their signs while m is less than the slack
/// (sqrt(L^2 + d) - L) / 2, and so the fan remains certified. In further frames, motions add.

#include <pelt/self_collide.hpp>

#include "self/self_filter.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace pelt::detail {

/// (A | b), column by column, with an upper bound of its `bend`.
struct JointStep {
  float m[12] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
  float bend = 0;
};

struct SelfTrack {
  explicit SelfTrack(const pelt::SelfFilter& f);

  pelt::SelfFilter filter;

  /// A cluster whose motion beside the step of a joint is measured: of its own anchor, or of that
  /// of a neighbour.
  struct Moved {
    std::uint32_t cluster;
    std::uint16_t anchor;
  };
  std::vector<Moved> moved;                 // [N] sorted by anchor
  std::vector<std::uint32_t> own_motions;   // [C] motion of a cluster beside its own anchor
  std::vector<std::uint32_t> pair_motions;  // of the second cluster, as PairMasks::masks
  std::vector<std::uint32_t> around_begin;  // [C + 1] into around
  std::vector<std::uint32_t> around;        // motions of a cluster and of its fans' clusters
  std::vector<std::uint32_t> fan_clusters;  // [F] of the closed and open fans
  std::vector<std::uint8_t> is_anchor;      // [J]

  // The last frame.
  bool has_frame = false;
  float extent = 0;                             // no coordinate is larger
  std::vector<Matrix4> palette;                 // [J]
  std::vector<std::array<float, 4>> positions;  // by place
  std::vector<float> pair_slack;                // as PairMasks::masks
  std::vector<float> fan_slack;                 // [F]
  std::vector<std::uint8_t> waits, last_waits;  // frames, as PairMasks::masks
  std::uint8_t rest = 0, last_rest = 0;         // frames

  // Working memory.
  std::vector<JointStep> steps;        // [J] only of anchors
  std::vector<float> motions;          // [N]
  std::vector<float> cluster_motions;  // [C] largest of `around`

  /// Whether to measure the distance of a pair without slack, and not only to test it.
  bool may_gain(std::uint32_t pair) {
    if (waits.data()[pair] == 0) return true;
    --waits.data()[pair];
    return false;
  }

  /// Sets the slack of a pair of this cluster. If its motion in this frame would have used up the
  /// slack, then the next frames only test the pair, which costs less: twice as many frames each
  /// time.
  void set_slack(std::uint32_t cluster, std::uint32_t pair, float slack) {
    const float motion =
        motions.data()[own_motions.data()[cluster]] + motions.data()[pair_motions.data()[pair]];
    pair_slack.data()[pair] = slack;
    std::uint8_t& last = last_waits.data()[pair];
    last = slack > motion ? 0 : longer(last);
    waits.data()[pair] = last;
  }

  /// Begins a frame. Returns false if the track rests in this frame: then nothing is remembered,
  /// which costs least for a body that moves fast, or whose layers touch everywhere.
  bool wakes();

  /// Ends a frame in which this number of pairs had slack.
  void rest_if_useless(std::size_t skipped_pairs);

  /// Writes `steps` from the last frame to this palette, and keeps the palette.
  void step_to(std::span<const Matrix4> next);

  std::size_t memory_bytes() const;

  /// Pairs of a cluster and one that is seen from its anchor, sorted.
  using Views = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

 private:
  static std::uint8_t longer(std::uint8_t wait) {
    constexpr int kFirst = 7, kMost = 127;
    return static_cast<std::uint8_t>(wait == 0 ? kFirst : wait < kMost ? 2 * wait + 1 : kMost);
  }
  void write_moved(const std::vector<std::uint16_t>& anchors, const Views& views);
};

}  // namespace pelt::detail
