#include "base/assert.hpp"
#include "base/vec3.hpp"
#include "model/bound_fit.hpp"
#include "model/intervals.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>
#include <utility>

namespace pelt::detail {
namespace {

using Joints = std::pair<std::uint16_t, std::uint16_t>;  // ascending

bool is_before(const JointLink& link, const Joints& joints) { return joints_of(link) < joints; }

}  // namespace

std::vector<JointLink> find_joint_links(const Tree& tree) {
  std::map<Joints, Intervals3> boxes;
  for (std::size_t place = 0; place < tree.rest_positions.size(); ++place) {
    const auto begin = tree.joints.begin() + tree.influence_begin[place];
    const auto end = tree.joints.begin() + tree.influence_begin[place + 1];
    for (auto a = begin; a != end; ++a)
      for (auto b = a + 1; b != end; ++b)
        boxes[std::minmax(*a, *b)].include(Vec3d(tree.rest_positions[place]));
  }
  std::vector<JointLink> links;
  for (const auto& [joints, box] : boxes) {
    JointLink& link = links.emplace_back(JointLink{joints.first, joints.second});
    box.store(link.centre, link.half);
  }
  return links;
}

std::uint32_t link_of(std::span<const JointLink> links, std::uint16_t a, std::uint16_t b) {
  const Joints joints = std::minmax(a, b);
  const auto found = std::lower_bound(links.begin(), links.end(), joints, is_before);
  PELT_ASSERT(found != links.end() && joints_of(*found) == joints);
  return static_cast<std::uint32_t>(found - links.begin());
}

namespace {

/// An influence with a weight that is divided by the sum of the vertex.
struct Share {
  std::uint32_t joint;
  double weight;
};

class PairFit {
 public:
  void include(const Vec3d& position, std::span<const Share> shares) {
    double products = 0, skews = 0;
    for (std::size_t i = 0; i < shares.size(); ++i)
      for (std::size_t j = i + 1; j < shares.size(); ++j) {
        const double a = shares[i].weight, b = shares[j].weight, product = a * b;
        const double skew = product * (std::fabs(a - b) / 2 + std::max(0.0, 1 - a - b));
        products += product;
        skews += skew;
        Sums& sums = sums_of(shares[i].joint, shares[j].joint);
        sums.box.include(position);
        sums.product.include(product);
        sums.skew = std::max(sums.skew, skew);
        sums.with_pivot &= i == 0;
        ++sums.count;
      }
    product_sum_ = std::max(product_sum_, products);
    skew_sum_ = std::max(skew_sum_, skews);
  }

  DualFit finish(const NodeVertices& vertices) const {
    const std::span<const std::uint16_t> joints = vertices.joints();
    DualFit fit;
    for (const Sums& sums : sums_) {
      JointPair pair;
      sums.box.store(pair.centre, pair.half);
      const bool is_everywhere = sums.count == vertices.places().size();
      pair.least = is_everywhere ? static_cast<float>(sums.product.low * (1 - 0x1p-20)) : 0;
      pair.most = up(sums.product.high);
      pair.skew = up(sums.skew);
      pair.link = link_of(vertices.links(), joints[sums.first], joints[sums.second]);
      pair.first = sums.first;
      pair.pivot = sums.with_pivot ? 1 : 0;
      fit.pairs.push_back(pair);
    }
    fit.product_sum = up(product_sum_);
    fit.skew_sum = up(skew_sum_);
    return fit;
  }

 private:
  struct Sums {
    std::uint32_t first, second;
    Intervals3 box = {};
    Interval product = {};
    double skew = 0;
    bool with_pivot = true;
    std::size_t count = 0;
  };

  /// More than the rounding of the sums, and never 1.
  static float up(double value) { return rounded_up(value * (1 + 0x1p-20)); }

  Sums& sums_of(std::uint32_t a, std::uint32_t b) {
    const auto [first, second] = std::minmax(a, b);
    const auto [known, is_new] = numbers_.try_emplace(first << 16 | second, sums_.size());
    if (is_new) sums_.push_back({first, second});
    return sums_[known->second];
  }

  std::unordered_map<std::uint32_t, std::size_t> numbers_;  // by pair of joints
  std::vector<Sums> sums_;                                  // in the order of the vertices
  double product_sum_ = 0, skew_sum_ = 0;
};

}  // namespace

DualFit fit_dual(const NodeVertices& vertices) {
  PairFit fit;
  std::vector<Share> shares;
  for (const std::uint32_t place : vertices.places()) {
    shares.clear();
    double sum = 0;
    vertices.each_weight(place, [&](std::uint32_t joint, double weight) {
      shares.push_back({joint, weight});
      sum += weight;
    });
    for (Share& share : shares) share.weight /= sum;
    fit.include(vertices.position(place), shares);
  }
  return fit.finish(vertices);
}

DualBound add_dual(const DualFit& fit, std::span<const std::uint16_t> joints,
                   const NodeBound& bound, NodeBounds& bounds) {
  const auto own = bounds.joints.begin() + bound.first_joint;
  const auto number = [&](std::uint32_t joint) {
    return static_cast<std::uint32_t>(std::find(own, own + bound.joint_count, joints[joint]) - own);
  };
  const auto first_pair = static_cast<std::uint32_t>(bounds.joint_pairs.size());
  for (JointPair pair : fit.pairs) {
    pair.first = number(pair.first);
    bounds.joint_pairs.push_back(pair);
  }
  return {first_pair, static_cast<std::uint32_t>(fit.pairs.size()), fit.product_sum, fit.skew_sum};
}

}  // namespace pelt::detail
