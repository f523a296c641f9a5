#include "scenes/creature/skin_weights.hpp"

#include <algorithm>
#include <cmath>

namespace pelt::scenes {
namespace {

constexpr double kBlendPerThickness = 1.0;  // width of a joint's transition
constexpr double kRounding = 0.5;           // of distances, per transition
constexpr double kFar = 1e9;                // farther than any muscle
constexpr double kSiblingBlend = 0.35;      // of the transition between the children of a joint

/// The smaller of two numbers, rounded off if they differ by less than `width`. A kink would be
/// visible as a crease in the posed skin.
double smooth_min(double a, double b, double width) {
  const double overlap = std::max(0.0, 1 - std::abs(a - b) / width);
  return std::min(a, b) - overlap * overlap * overlap * width / 6;
}

/// 1 at 0, decreasing smoothly to 0 at `width`.
double fade(double x, double width) {
  const double t = std::clamp(x / width, 0.0, 1.0);
  return (1 - t) * (1 - t) * (1 + 2 * t);
}

/// The four largest weights minus the fifth: a joint enters and leaves the four at weight 0, so
/// weights are continuous over the skin.
VertexWeights four_largest(std::span<const double> weights) {
  std::vector<std::uint32_t> order;
  for (std::uint32_t j = 0; j < weights.size(); ++j) {
    if (weights[j] > 0) order.push_back(j);
  }
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return weights[a] != weights[b] ? weights[a] > weights[b] : a < b;
  });
  const double fifth = order.size() > kInfluences ? weights[order[kInfluences]] : 0;
  const std::size_t count = std::min<std::size_t>(order.size(), kInfluences);
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += weights[order[i]] - fifth;
  VertexWeights result;
  for (std::size_t i = 0; i < count && sum > 0; ++i) {
    result.weights[i] = (weights[order[i]] - fifth) / sum;
    result.joints[i] = result.weights[i] > 0 ? order[i] : 0;
  }
  if (!(sum > 0)) {
    result.joints[0] = order.front();
    result.weights[0] = 1;
  }
  return result;
}

}  // namespace

SkinWeights::SkinWeights(const BodyPlan& plan, std::span<const std::uint32_t> stands_for)
    : plan_(plan),
      stands_for_(stands_for.begin(), stands_for.end()),
      children_(stands_for.size()),
      parent_(stands_for.size(), kNone),
      own_(stands_for.size()),
      branch_(stands_for.size()),
      reach_(stands_for.size()),
      weight_(stands_for.size()) {
  for (std::uint32_t j = 0; j < stands_for_.size(); ++j) {
    if (stands_for_[j] != j) continue;
    joints_.push_back(j);
    if (plan.joints[j].parent == kNone) continue;
    parent_[j] = stands_for_[plan.joints[j].parent];
    children_[parent_[j]].push_back(j);
  }
}

VertexWeights SkinWeights::at(const Vec3d& point) {
  const double width = kBlendPerThickness * sample_flesh(plan_.flesh, point).thickness;
  measure_distances(point, kRounding * width);
  share_out(width);
  return four_largest(weight_);
}

void SkinWeights::measure_distances(const Vec3d& point, double rounding) {
  std::fill(own_.begin(), own_.end(), kFar);
  for (const Limb& limb : plan_.flesh.limbs) {
    for (const Muscle& muscle : limb.muscles) {
      double& own = own_[stands_for_[muscle.joint]];
      own = smooth_min(own, muscle_distance(muscle, point), rounding);
    }
  }
  branch_ = own_;
  for (auto j = joints_.rbegin(); j != joints_.rend(); ++j) {
    if (parent_[*j] == kNone) continue;
    double& parent = branch_[parent_[*j]];
    parent = smooth_min(parent, branch_[*j], rounding);
  }
}

void SkinWeights::share_out(double width) {
  std::fill(reach_.begin(), reach_.end(), 0.0);
  std::fill(weight_.begin(), weight_.end(), 0.0);
  reach_[joints_.front()] = 1;
  for (std::uint32_t j : joints_) {
    if (reach_[j] > 0) share_of(j, width);
  }
}

void SkinWeights::share_of(std::uint32_t joint, double width) {
  double nearest_child = kFar;
  for (std::uint32_t child : children_[joint]) {
    nearest_child = std::min(nearest_child, branch_[child]);
  }
  const double nearest = std::min(own_[joint], nearest_child);
  const double own = fade(own_[joint] - nearest, width);
  double sum = own;
  for (std::uint32_t child : children_[joint]) {
    reach_[child] = fade(branch_[child] - nearest, width) *
                    fade(branch_[child] - nearest_child, kSiblingBlend * width);
    sum += reach_[child];
  }
  weight_[joint] = reach_[joint] * own / sum;
  for (std::uint32_t child : children_[joint]) reach_[child] *= reach_[joint] / sum;
}

}  // namespace pelt::scenes
