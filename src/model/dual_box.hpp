#pragma once

/// Evaluates what dual quaternion skinning adds to the box of a node; dual_bounds.hpp has the
/// formulas and their proof.

#include "geometry/box4.hpp"
#include "model/node_bounds.hpp"
#include "model/rest_images.hpp"
#include "skin/palette.hpp"

#include <cmath>
#include <span>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// The difference of a posed vertex from that of linear blend skinning is between low and high.
struct DualShift {
  Float4 low, high;
  float margin;  ///< to add on every side
};

/// How much wider a box may get, on each side, before its shift is bounded more tightly.
inline constexpr float kShiftTolerance = 0x1p-3f;

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
  /// Otherwise uses the pairs' own boxes where they are smaller and this matters.
  DualShift run(const Float4& tolerance) {
    find_signs();
    if (has_signs_) {
      const DualShift shift = finish(sum_links());
      if (is_within(max(shift.high, Float4(0.0f) - shift.low), tolerance)) return shift;
    }
    return finish(sum_pairs(tolerance));
  }

 private:
  static constexpr float kSecondOrder = 1 + 0x1p-14f;

  /// The sum over all pairs, and the hull of zero and all pairs.
  struct Sums {
    Float4 low = Float4(0.0f), high = Float4(0.0f);
    Float4 size = Float4(0.0f);  // of the terms that may cancel
    Float4 hull_low = Float4(0.0f), hull_high = Float4(0.0f);
    Float4 swell = Float4(0.0f), hull_swell = Float4(0.0f);  // without the longest chord
    float squared = 0, largest_squared = 0;
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
    has_signs_ = palette_.negates_none() || least_cosine_ >= 0.5f + kCosineRounding || other < 0;
  }

  /// Precondition: all signs are known.
  Sums sum_links() const {
    const Float4 zero(0.0f);
    Sums sums;
    for (const JointPair& pair : pairs_) {
      const LinkMotion& link = motion(pair);
      const Float4 low = load4(link.low), high = load4(link.high), swell = load4(link.swell);
      sums.low = sums.low + Float4(pair.most) * min(low, zero);
      sums.high = sums.high + Float4(pair.most) * max(high, zero);
      sums.hull_low = min(sums.hull_low, low), sums.hull_high = max(sums.hull_high, high);
      sums.swell = sums.swell + Float4(pair.skew) * swell;
      sums.hull_swell = max(sums.hull_swell, swell);
    }
    sums.squared = sums.high[3], sums.largest_squared = sums.hull_high[3];
    return sums;
  }

  Sums sum_pairs(const Float4& tolerance) const {
    Sums sums;
    Float4 left = tolerance;
    for (const JointPair& pair : pairs_) {
      const LinkMotion& link = motion(pair);
      const Float4 low = load4(link.low), high = load4(link.high);
      const Float4 far = max(high, Float4(0.0f) - low);
      const bool is_signed = has_signs_ || pair.pivot > 0;
      const bool is_small = is_within(Float4(4 * pair.most) * far, left);
      if (is_signed && (is_small || is_like_link(pair))) {
        add(pair, {low, high}, load4(link.swell), link.high[3], sums);
        if (is_small) left = left - Float4(pair.most) * far;
      } else {
        add_own_box(pair, is_signed, sums);
      }
    }
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
    const float squared = is_signed ? link.high[3] : 2 * (1 + link.swell[3]) + kCosineRounding;
    const Float4 swell = Float4(std::sqrt(squared)) * (abs(way) + reach + slack);
    add(pair, is_signed ? Box4{middle - half, middle + half} : Box4{Float4(0.0f) - far, far}, swell,
        squared, sums);
  }

  static void add(const JointPair& pair, const Box4& shift, const Float4& swell, float squared,
                  Sums& sums) {
    const Float4 least(pair.least), most(pair.most);
    sums.low = sums.low + min(most * shift.low, least * shift.low);
    sums.high = sums.high + max(most * shift.high, least * shift.high);
    sums.size = sums.size + most * max(abs(shift.low), abs(shift.high));
    sums.hull_low = min(sums.hull_low, shift.low);
    sums.hull_high = max(sums.hull_high, shift.high);
    sums.swell = sums.swell + Float4(pair.skew) * swell;
    sums.hull_swell = max(sums.hull_swell, swell);
    sums.squared += pair.most * squared;
    sums.largest_squared = sums.largest_squared < squared ? squared : sums.largest_squared;
  }

  DualShift finish(const Sums& sums) const {
    const float n = least_n(sums.squared, sums.largest_squared);
    const Float4 stretch(kSecondOrder / n), products(dual_.product_sum), skews(dual_.skew_sum);
    Float4 low = products * sums.hull_low, high = products * sums.hull_high;
    Float4 swell = skews * sums.hull_swell;
    if (is_summed()) {
      const Float4 rounding = Float4(0x1p-14f) * sums.size;
      low = max(low, sums.low - rounding);
      high = min(high, sums.high + rounding);
      swell = min(swell, sums.swell);
    }
    swell = Float4(std::sqrt(sums.largest_squared)) * swell * stretch;
    return {min(low, low * stretch) - swell, max(high, high * stretch) + swell, margin(n)};
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

  /// Sums over more pairs round too much.
  bool is_summed() const { return pairs_.size() <= 200; }

  /// A lower bound of n of all vertices of the node. `squared` is the sum over all pairs.
  float least_n(float squared, float largest_squared) const {
    const float k = influences_;
    const float cosine = least_cosine_ > kCosineRounding ? least_cosine_ - kCosineRounding : 0;
    const float along = 1 / k + (1 - 1 / k) * cosine;
    const float hull = dual_.product_sum * largest_squared;
    const float by_chords = 1 - (is_summed() && squared < hull ? squared : hull);
    const float n = along * along < by_chords ? by_chords : along * along;
    return n * (1 - 0x1p-10f) - 0x1p-14f;
  }

  float margin(float n) const {
    constexpr float kUnit = 0x1p-24f * (1 + 0x1p-6f);
    return (2.1f * influences_ / std::sqrt(n) + 60) * kUnit * palette_.extent();
  }

  const NodeBounds& bounds_;
  const NodeBound& bound_;
  const DualBound& dual_;
  std::span<const JointPair> pairs_;
  const Palette& palette_;
  float influences_;
  float least_cosine_ = 1;  // of all |D|
  bool has_signs_ = false;  // no cosine is negative
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
  return intersect({box.low + shift.low - margin, box.high + shift.high + margin},
                   {Float4(0.0f) - most, most});
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
