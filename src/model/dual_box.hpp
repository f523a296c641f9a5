#pragma once

/// Evaluates what dual quaternion skinning adds to the box of a node; node_bounds.hpp has the
/// formulas and their proof.

#include "geometry/box4.hpp"
#include "model/node_bounds.hpp"
#include "model/rest_images.hpp"
#include "skin/palette.hpp"

#include <cmath>
#include <span>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// The difference of a posed vertex from that of linear blend skinning is between -down and up, the
/// low and the high half.
struct DualShift {
  Float8 down_up;
  float margin;  ///< to add on every side
};

/// How much wider a box may get, on each side, before its shift is bounded more tightly.
inline constexpr float kShiftTolerance = 0x1p-3f;

/// Most pairs that are summed. Sums over more than 200 would round too much (node_bounds.hpp); a
/// node with so many is near the root, where a loose box costs less than a long sum.
inline constexpr std::size_t kMostSummed = 100;

/// Computes the shift of one node.
class DualShiftOf {
 public:
  DualShiftOf(const NodeBounds& bounds, std::uint32_t node, const Palette& palette)
      : bounds_(bounds),
        bound_(bounds.nodes[node]),
        dual_(bounds.dual_bounds[node]),
        pairs_(bounds.joint_pairs.data() + dual_.first_pair, dual_.pair_count),
        palette_(palette),
        influences_(static_cast<float>(palette.dual_influences())) {}

  /// Bounds the shift by the boxes of the links, unless this exceeds `tolerance` on an axis.
  /// Otherwise uses the pairs' own boxes where they are smaller and this matters. A node with very
  /// many pairs, near the root, uses the hull of all links.
  DualShift run(const Float4& tolerance) {
    has_signs_ = palette_.negates_none();
    if (has_signs_ && !can_sum()) return finish(hull_of_links());
    if (!has_signs_) find_signs();
    if (has_signs_) {
      const DualShift shift = finish(sum_links());
      if (is_within(max(shift.down_up.low(), shift.down_up.high()), tolerance)) return shift;
    }
    return finish(sum_pairs(tolerance));
  }

 private:
  static constexpr float kSecondOrder = 1 + 0x1p-14f;

  /// The sum over all pairs, and the hull of zero and all pairs.
  struct Sums {
    Float8 down_up{0.0f};
    Float8 size{0.0f};  // of the terms that may cancel
    Float8 hull{0.0f};
    Float4 swell{0.0f}, hull_swell{0.0f};  // without the longest chord
    float squared = 0, largest_squared = 0;
    bool has_sums = true;  // otherwise only the hull
  };

  static bool is_within(const Float4& size, const Float4& limit) {
    return ((size <= limit).bits() & 7) == 7;
  }

  const LinkMotion& motion(const JointPair& pair) const {
    return palette_.link_motions()[pair.link];
  }

  void find_signs() {
    float other = -1;
    for (const JointPair& pair : pairs_) {
      const float cosine = motion(pair).swell[3];
      least_cosine_ = cosine < least_cosine_ ? cosine : least_cosine_;
      if (pair.pivot == 0 && cosine > other) other = cosine;
    }
    has_signs_ = least_cosine_ >= 0.5f + kCosineRounding || other < 0;
  }

  /// Precondition: all signs are known.
  Sums hull_of_links() const {
    const LinkHull& links = palette_.link_hull();
    Sums sums;
    sums.hull = load8(links.down_up), sums.hull_swell = load4(links.swell);
    sums.largest_squared = links.down_up[7];
    sums.has_sums = false;
    return sums;
  }

  /// Precondition: all signs are known.
  Sums sum_links() const {
    Sums sums;
    for (const JointPair& pair : pairs_) {
      const LinkMotion& link = motion(pair);
      const Float8 down_up = max(load8(link.down_up), Float8(0.0f));
      const Float4 swell = load4(link.swell);
      sums.down_up = sums.down_up + Float8(pair.most) * down_up;
      sums.hull = max(sums.hull, down_up);
      sums.swell = sums.swell + Float4(pair.skew) * swell;
      sums.hull_swell = max(sums.hull_swell, swell);
    }
    sums.squared = sums.down_up.high()[3], sums.largest_squared = sums.hull.high()[3];
    sums.has_sums = can_sum();
    return sums;
  }

  Sums sum_pairs(const Float4& tolerance) const {
    Sums sums;
    Float4 left = tolerance;
    for (const JointPair& pair : pairs_) {
      const LinkMotion& link = motion(pair);
      const Float8 down_up = load8(link.down_up);
      const Float4 far = max(down_up.low(), down_up.high());
      const bool is_signed = has_signs_ || pair.pivot > 0;
      const bool is_small = is_within(Float4(4 * pair.most) * far, left);
      if (is_signed && (is_small || is_like_link(pair))) {
        add(pair, down_up, load4(link.swell), link.down_up[7], sums);
        if (is_small) left = left - Float4(pair.most) * far;
      } else {
        add_own_box(pair, is_signed, sums);
      }
    }
    sums.has_sums = can_sum();
    return sums;
  }

  /// Whether the pair's box is not much smaller than that of the link.
  bool is_like_link(const JointPair& pair) const {
    const Float4 half = load4(palette_.links()[pair.link].half);
    return is_within(Float4(0.75f) * half, load4(pair.half));
  }

  void add_own_box(const JointPair& pair, bool is_signed, Sums& sums) const {
    const LinkMotion& link = motion(pair);
    const JointLink& joints = palette_.links()[pair.link];
    const ColumnPairs apart =
        load_columns(palette_[joints.first]) - load_columns(palette_[joints.second]);
    const JointBox box = rest_box(pair);
    const Float4 slack(palette_.link_slack()), turn = load4(link.turn);
    const Float4 way = fold(image(apart, box.centre));
    const Float4 reach = fold(image(magnitudes(apart), box.half));
    const Float4 middle = cross(way, turn);
    const Float4 half = cross_magnitude(reach, abs(turn)) + slack;
    const Float4 far = abs(middle) + half;
    const float squared = is_signed ? link.down_up[7] : 2 * (1 + link.swell[3]) + kCosineRounding;
    const Float4 swell = Float4(std::sqrt(squared)) * (abs(way) + reach + slack);
    add(pair, is_signed ? Float8(half - middle, half + middle) : Float8(far, far), swell, squared,
        sums);
  }

  static void add(const JointPair& pair, const Float8& down_up, const Float4& swell, float squared,
                  Sums& sums) {
    const Float8 most = Float8(pair.most) * down_up;
    sums.down_up = sums.down_up + max(most, Float8(pair.least) * down_up);
    sums.size = sums.size + abs(most);
    sums.hull = max(sums.hull, down_up);
    sums.swell = sums.swell + Float4(pair.skew) * swell;
    sums.hull_swell = max(sums.hull_swell, swell);
    sums.squared += pair.most * squared;
    sums.largest_squared = sums.largest_squared < squared ? squared : sums.largest_squared;
  }

  DualShift finish(const Sums& sums) const {
    const float longest = kSecondOrder / least_n(sums);
    const Float8 stretch(longest);
    Float8 down_up = Float8(dual_.product_sum) * sums.hull;
    Float4 swell = Float4(dual_.skew_sum) * sums.hull_swell;
    if (sums.has_sums) {
      down_up = min(down_up, sums.down_up + Float8(0x1p-14f) * sums.size);
      swell = min(swell, sums.swell);
    }
    swell = Float4(std::sqrt(sums.largest_squared)) * swell;
    return {max(down_up, down_up * stretch) + Float8(swell, swell) * stretch, margin(longest)};
  }

  /// The rest box of a pair, displaced by active morph targets.
  JointBox rest_box(const JointPair& pair) const {
    JointBox box;
    store4(box.centre, load4(pair.centre)), store4(box.half, load4(pair.half));
    if (!palette_.morphs().any()) return box;
    const std::size_t body = bound_.is_affine() ? bounds_.joint_boxes.size() + bound_.shape
                                                : bound_.first_record + pair.first;
    return displacement_of(bounds_, body, palette_.morphs()).displaced(pair.centre, pair.half);
  }

  bool can_sum() const { return pairs_.size() <= kMostSummed; }

  /// A lower bound of n of all vertices of the node.
  float least_n(const Sums& sums) const {
    const float k = influences_;
    const float least = has_signs_ ? 1 - 0.5f * sums.largest_squared : least_cosine_;
    const float cosine = least > kCosineRounding ? least - kCosineRounding : 0;
    const float along = 1 / k + (1 - 1 / k) * cosine;
    const float hull = dual_.product_sum * sums.largest_squared;
    const float by_chords = 1 - (sums.has_sums && sums.squared < hull ? sums.squared : hull);
    const float n = along * along < by_chords ? by_chords : along * along;
    return n * (1 - 0x1p-10f) - 0x1p-14f;
  }

  /// Uses 1 / n, which is at least R, because a root would take longer.
  float margin(float longest_stretch) const {
    constexpr float kUnit = 0x1p-24f * (1 + 0x1p-6f);
    return (2.1f * influences_ * longest_stretch + 60) * kUnit * palette_.extent();
  }

  const NodeBounds& bounds_;
  const NodeBound& bound_;
  const DualBound& dual_;
  std::span<const JointPair> pairs_;
  const Palette& palette_;
  float influences_;
  bool has_signs_ = false;  // no cosine is negative
  float least_cosine_ = 1;  // of all |D|; set if not all signs are known
};

/// Not inlined, so that models with linear blend skinning pay nothing.
[[gnu::noinline]] inline DualShift dual_shift(const NodeBounds& bounds, std::uint32_t node,
                                              const Palette& palette, const Float4& tolerance) {
  return DualShiftOf(bounds, node, palette).run(tolerance);
}

/// Moves a box of linear blend skinning.
[[gnu::noinline]] inline Box4 dual_box(const NodeBounds& bounds, std::uint32_t node,
                                       const Palette& palette, const Box4& box,
                                       float tolerance = kShiftTolerance) {
  const Float4 most_shift = Float4(tolerance) * (box.high - box.low);
  const DualShift shift = dual_shift(bounds, node, palette, most_shift);
  const Float4 margin(shift.margin), most((1 + 0x1p-12f) * palette.extent());
  return intersect(
      {box.low - shift.down_up.low() - margin, box.high + shift.down_up.high() + margin},
      {Float4(0.0f) - most, most});
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
