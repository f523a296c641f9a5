/// Updates the slack of pairs and fans at the start of a frame; self_track.hpp defines A, b, v, v'
/// and bend.
///
/// Rounding. With e = 2^-24, M the largest coordinate of old and new vertices, and N that of b:
/// bend is below 0.5, so the singular values of A are below 1.225, and its rows have sums of
/// magnitudes below 2.13. A coordinate of A v + b has an error of at most 4.1 e (2.13 M + N), and
/// the difference from v' at most e (3.2 M + 1.1 N) more. The length of a vector is at most 1.74
/// times its largest coordinate, and 2^-20 (2 M + N) covers all. 2^-70 covers products and squares
/// that underflow. The relative errors of lengths and sums are covered by factors 1 + 2^-20. |v| is
/// at most 1.7321 M.

#include "self/self_track.hpp"

#include "geometry/points8.hpp"
#include "pose/open_node.hpp"
#include "query/triangle_batch.hpp"

#include <cmath>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

constexpr float kUp = 1 + 0x1p-20f, kDown = 1 - 0x1p-20f;

float larger(float a, float b) { return a < b ? b : a; }
float magnitude(float a) { return a < 0 ? -a : a; }

float largest_coordinate(const RootBox& box) {
  float largest = 0;
  for (int axis = 0; axis < 3; ++axis)
    largest = larger(largest, larger(magnitude(box.low[axis]), magnitude(box.high[axis])));
  return largest;
}

/// A step of a joint in all lanes.
struct Step8 {
  explicit Step8(const JointStep& step) {
    for (int i = 0; i < 12; ++i) m[i] = Float8(step.columns[i]);
  }

  Points8 operator()(const Points8& p) const {
    return {m[0] * p.x + m[3] * p.y + m[6] * p.z + m[9],
            m[1] * p.x + m[4] * p.y + m[7] * p.z + m[10],
            m[2] * p.x + m[5] * p.y + m[8] * p.z + m[11]};
  }

  Float8 m[12];
};

/// How far the vertices of clusters move relative to the steps of joints.
class Motion {
 public:
  Motion(const PosedTree& posed, const SelfTrack& track, float extent)
      : posed_(posed), track_(track), extent_(extent) {}

  /// Returns an upper bound of the motion of a cluster relative to R (see self_track.hpp).
  float operator()(const SelfTrack::Moved& cluster, const Step8& step8) const {
    const JointStep& step = track_.steps.data()[cluster.anchor];
    float offset = 0;
    for (int i = 9; i < 12; ++i) offset = larger(offset, magnitude(step.columns[i]));
    const float rounding = 0x1p-20f * (2 * extent_ + offset) + 0x1p-70f;
    const float bending = 1.7321f * step.bend * extent_;
    return (std::sqrt(largest_squared(cluster.cluster, step8)) + rounding + bending) * kUp;
  }

 private:
  float largest_squared(std::uint32_t number, const Step8& step) const {
    const Tree& tree = posed_.tree;
    const Cluster& cluster = tree.clusters.data()[number];
    const std::uint32_t n = track_.filter.detail().masks.cluster_nodes.data()[number];
    const float* const now = posed_.opened[n]->positions;
    const float* const old = track_.positions.data()[tree.nodes.data()[n].first_vertex].data();
    const std::uint16_t* const vertices = tree.cluster_vertices.data() + cluster.first_vertex;
    const std::uint32_t last = cluster.vertex_count - 1u;
    Float8 largest(0.0f);
    for (std::uint32_t first = 0; first <= last; first += kBatch) {
      const auto at = [&](std::uint32_t lane) {
        return vertices[first + lane < last ? first + lane : last];
      };
      const Points8 from = gather_points([&](std::uint32_t lane) { return old + at(lane); });
      const Points8 to = gather_points([&](std::uint32_t lane) { return now + at(lane); });
      const Points8 way = to - step(from);
      largest = max(largest, dot(way, way));
    }
    float lanes[kBatch];
    largest.store(lanes);
    float most = 0;
    for (const float lane : lanes) most = larger(most, lane);
    return most;
  }

  const PosedTree& posed_;
  const SelfTrack& track_;
  float extent_;
};

void measure_motions(const PosedTree& posed, float extent, SelfTrack& track) {
  const Motion motion(posed, track, extent);
  const SelfTrack::Moved* const moved = track.moved.data();
  for (std::size_t i = 0; i < track.moved.size();) {
    const std::uint16_t anchor = moved[i].anchor;
    const Step8 step(track.steps.data()[anchor]);
    for (; i < track.moved.size() && moved[i].anchor == anchor; ++i)
      track.motions.data()[i] = motion(moved[i], step);
  }
}

/// Returns the number of pairs that have slack left.
std::size_t reduce_slack(SelfTrack& track) {
  const PairMasks& masks = track.filter.detail().masks;
  const float* const motions = track.motions.data();
  const std::size_t cluster_count = track.own_motions.size();
  std::size_t left = 0;
  for (std::size_t c = 0; c < cluster_count; ++c) {
    const float own = motions[track.own_motions.data()[c]];
    for (std::uint32_t i = masks.begin.data()[c]; i < masks.begin.data()[c + 1]; ++i) {
      float& slack = track.pair_slack.data()[i];
      slack = slack * kDown - (own + motions[track.pair_motions.data()[i]]) * kUp;
      left += slack > 0;
    }
    float most = 0;
    for (std::uint32_t i = track.around_begin.data()[c]; i < track.around_begin.data()[c + 1]; ++i)
      most = larger(most, motions[track.around.data()[i]]);
    track.cluster_motions.data()[c] = most * kUp;
  }
  for (std::size_t fan = 0; fan < track.fan_slack.size(); ++fan) {
    float& slack = track.fan_slack.data()[fan];
    slack = slack * kDown - track.cluster_motions.data()[track.fan_clusters.data()[fan]];
  }
  return left;
}

}  // namespace

void write_positions(const PosedTree& posed, std::array<float, 4>* positions) {
  for (std::uint32_t n = 0; n < posed.tree.nodes.size(); ++n) {
    const Node& node = posed.tree.nodes.data()[n];
    const float* from = posed.opened[n]->positions;
    for (std::uint32_t v = 0; v < node.vertex_count; ++v)
      store4(positions[node.first_vertex + v].data(),
             load4(from + std::size_t{kFloatsPerVertex} * v));
  }
}

void begin_frame(const PosedTree& posed, SelfTrack& track, QueryStats& work) {
  const float extent = largest_coordinate(root_box(posed, work));
  track.step_to(posed.palette.joints());
  if (track.has_frame) {
    measure_motions(posed, larger(extent, track.extent), track);
    track.pause_if_useless(reduce_slack(track));
  }
  write_positions(posed, track.positions.data());
  track.extent = extent;
  track.has_frame = true;
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
