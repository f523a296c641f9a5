#pragma once

/// Evaluates what dual quaternion skinning adds to the box of a node; dual_bounds.hpp has the
/// formulas and their proof.

#include "geometry/points8.hpp"
#include "model/node_bounds.hpp"
#include "model/rest_images.hpp"
#include "skin/dual_skin.hpp"

#include <cmath>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// The difference of a posed vertex from that of linear blend skinning is between low and high.
struct DualShift {
  Float4 low, high;
  float margin;  ///< to add on every side
};

/// Combines the lanes of each coordinate.
template <typename Combine>
inline Float4 combined(const Points8& p, const Combine& combine) {
  Float4 x = combine(p.x.low(), p.x.high()), y = combine(p.y.low(), p.y.high());
  Float4 z = combine(p.z.low(), p.z.high()), unused = z;
  transpose(x, y, z, unused);
  return combine(combine(x, y), combine(z, unused));
}

inline Float4 sum_of(const Points8& p) {
  return combined(p, [](const Float4& a, const Float4& b) { return a + b; });
}
inline Float4 least_of(const Points8& p) {
  return combined(p, [](const Float4& a, const Float4& b) { return min(a, b); });
}
inline Float4 most_of(const Points8& p) {
  return combined(p, [](const Float4& a, const Float4& b) { return max(a, b); });
}

/// Loads the floats `at(0)` to `at(7)`, four each.
template <typename At>
inline Rows8 gather_rows(const At& at) {
  return rows8(load4(at(0)), load4(at(1)), load4(at(2)), load4(at(3)), load4(at(4)), load4(at(5)),
               load4(at(6)), load4(at(7)));
}

/// Eight pairs of joints of a node. Lanes beyond the last pair repeat it without weights.
class JointPairs8 {
 public:
  JointPairs8(const NodeBounds& bounds, const NodeBound& bound, const Palette& palette,
              const JointPair* pairs, std::uint32_t count)
      : bounds_(bounds), bound_(bound), palette_(palette), count_(count) {
    const std::uint16_t* joints = bounds.joints.data() + bound.first_joint;
    for (std::uint32_t lane = 0; lane < 8; ++lane) {
      pair_[lane] = pairs + (lane < count ? lane : count - 1);
      first_[lane] = joints[pair_[lane]->first];
      second_[lane] = joints[pair_[lane]->second];
    }
  }

  /// Least, most, skew and pivot of the pairs.
  Rows8 weights() const {
    static constexpr float kNone[] = {0, 0, 0, 1};
    return gather_rows(
        [&](std::uint32_t lane) { return lane < count_ ? &pair_[lane]->least : kNone; });
  }

  Rows8 first_rotations() const { return rotations(first_); }
  Rows8 second_rotations() const { return rotations(second_); }

  /// The images of the rest boxes under the difference of both joints: centres, half extents.
  void measure(Points8& way, Points8& reach) const {
    JointBox displaced[8];
    const float *centres[8], *halves[8];
    for (std::uint32_t lane = 0; lane < 8; ++lane) {
      centres[lane] = pair_[lane]->centre, halves[lane] = pair_[lane]->half;
      if (!palette_.morphs().any()) continue;
      displaced[lane] = displaced_box(*pair_[lane]);
      centres[lane] = displaced[lane].centre, halves[lane] = displaced[lane].half;
    }
    const Rows8 centre = gather_rows([&](std::uint32_t lane) { return centres[lane]; });
    const Rows8 half = gather_rows([&](std::uint32_t lane) { return halves[lane]; });
    const Points8 x = column(0), y = column(1), z = column(2);
    way = (centre.x * x + centre.y * y) + (centre.z * z + column(3));
    reach = half.x * magnitude(x) + half.y * magnitude(y) + half.z * magnitude(z);
  }

  static Points8 magnitude(const Points8& p) { return {abs(p.x), abs(p.y), abs(p.z)}; }

 private:
  Rows8 rotations(const std::uint16_t (&joints)[8]) const {
    const DualQuaternion* duals = palette_.duals().data();
    return gather_rows([&](std::uint32_t lane) { return duals[joints[lane]].real; });
  }

  /// A column of the differences of the matrices.
  Points8 column(std::uint32_t number) const {
    const Matrix4* matrices = palette_.joints().data();
    const std::size_t at = std::size_t{4} * number;
    const auto difference = [&](std::uint32_t lane) {
      return load4(matrices[first_[lane]].m.data() + at) -
             load4(matrices[second_[lane]].m.data() + at);
    };
    return transpose8(difference(0), difference(1), difference(2), difference(3), difference(4),
                      difference(5), difference(6), difference(7));
  }

  JointBox displaced_box(const JointPair& pair) const {
    const std::size_t body = bound_.is_affine() ? bounds_.joint_boxes.size() + bound_.shape
                                                : bound_.first_record + pair.first;
    return displacement_of(bounds_, body, palette_.morphs()).displaced(pair.centre, pair.half);
  }

  const NodeBounds& bounds_;
  const NodeBound& bound_;
  const Palette& palette_;
  std::uint32_t count_;
  const JointPair* pair_[8];
  std::uint16_t first_[8], second_[8];
};

/// Computes the shift of one node.
class DualShiftOf {
 public:
  DualShiftOf(const NodeBounds& bounds, std::uint32_t node, const Palette& palette)
      : bounds_(bounds),
        bound_(bounds.nodes[node]),
        dual_(bounds.dual_bounds[node]),
        palette_(palette),
        influences_(static_cast<float>(palette.dual_influences())),
        slack_(0x1p-18f * palette.extent() *
               static_cast<float>(1 + palette.morphs().active().size())) {}

  DualShift run() {
    add_all(true);
    const Float4 most = most_of({largest_squared_, zero() - least_cosine_, most_other_cosine_});
    const float largest_squared = most[0], least = -most[1], other = most[2];
    if (least >= 0.5f + kCosineRounding || other < 0) return finish(largest_squared, least);
    sums_ = Sums();
    products_ = zero(), largest_squared_ = zero();
    add_all(false);
    const float squared = most_of({largest_squared_, zero(), zero()})[0];
    return finish(squared, least);
  }

 private:
  static constexpr float kSecondOrder = 1 + 0x1p-14f;
  static constexpr float kCosineRounding = 0x1p-20f;

  static Float8 zero() { return Float8(0.0f); }
  static Points8 zeros() { return {zero(), zero(), zero()}; }
  static Points8 lower(const Points8& p, const Points8& q) {
    return {min(p.x, q.x), min(p.y, q.y), min(p.z, q.z)};
  }
  static Points8 higher(const Points8& p, const Points8& q) {
    return {max(p.x, q.x), max(p.y, q.y), max(p.z, q.z)};
  }

  /// One lane for each of eight pairs.
  struct Sums {
    Points8 low = zeros(), high = zeros();            // of the products
    Points8 size = zeros();                           // of their magnitudes
    Points8 hull_low = zeros(), hull_high = zeros();  // of all pairs and zero
    Points8 swell = zeros(), hull_swell = zeros();    // without the longest chord
  };

  /// `has_signs`: the signs of all cosines are known.
  void add_all(bool has_signs) {
    const JointPair* const pairs = bounds_.joint_pairs.data() + dual_.first_pair;
    for (std::uint32_t i = 0; i < dual_.pair_count; i += 8)
      add({bounds_, bound_, palette_, pairs + i,
           dual_.pair_count - i < 8 ? dual_.pair_count - i : 8},
          has_signs);
  }

  void add(const JointPairs8& pairs, bool has_signs) {
    const Rows8 weights = pairs.weights();
    const Rows8 a = pairs.first_rotations(), b = pairs.second_rotations();
    const Float8 cosine = (a.x * b.x + a.z * b.z) + (a.y * b.y + a.w * b.w);
    const Float8 magnitude = abs(cosine);
    const Mask8 is_signed = has_signs ? zero() <= zero() : zero() < weights.w;
    const Mask8 is_other = weights.w <= zero();
    least_cosine_ = min(least_cosine_, magnitude);
    most_other_cosine_ = max(most_other_cosine_, select(is_other, magnitude, Float8(-1.0f)));
    const Float8 acute = select(is_signed, magnitude, zero() - magnitude);
    const Float8 squared = Float8(2.0f) * (Float8(1.0f) - acute) + Float8(kCosineRounding);
    products_ = products_ + weights.y * squared;
    largest_squared_ = max(largest_squared_, squared);
    // The vector part of a b*, of a known sign.
    const Points8 u = {b.w * a.x - a.w * b.x - (a.y * b.z - a.z * b.y),
                       b.w * a.y - a.w * b.y - (a.z * b.x - a.x * b.z),
                       b.w * a.z - a.w * b.z - (a.x * b.y - a.y * b.x)};
    const Float8 sign = select(cosine < zero(), Float8(-1.0f), Float8(1.0f));
    add_products(pairs, weights, sign * u, sqrt(squared), is_signed);
  }

  void add_products(const JointPairs8& pairs, const Rows8& weights, const Points8& u,
                    const Float8& chord, const Mask8& is_signed) {
    Points8 way, reach;
    pairs.measure(way, reach);
    const Float8 slack(slack_);
    const Points8 v = JointPairs8::magnitude(u), middle = cross(way, u);
    const Points8 half = {reach.y * v.z + reach.z * v.y + slack,
                          reach.z * v.x + reach.x * v.z + slack,
                          reach.x * v.y + reach.y * v.x + slack};
    const Points8 far = JointPairs8::magnitude(middle) + half;
    const Points8 low = select(is_signed, middle - half, zeros() - far);
    const Points8 high = select(is_signed, middle + half, far);
    sums_.low = sums_.low + lower(weights.y * low, weights.x * low);
    sums_.high = sums_.high + higher(weights.y * high, weights.x * high);
    sums_.size = sums_.size + weights.y * far;
    sums_.hull_low = lower(sums_.hull_low, low);
    sums_.hull_high = higher(sums_.hull_high, high);
    const Points8 swell =
        chord * (JointPairs8::magnitude(way) + reach + Points8{slack, slack, slack});
    sums_.swell = sums_.swell + weights.z * swell;
    sums_.hull_swell = higher(sums_.hull_swell, swell);
  }

  /// Sums over more pairs round too much.
  bool is_summed() const { return dual_.pair_count <= 200; }

  /// A lower bound of n of all vertices of the node.
  float least_n(float largest_squared, float least_cosine) const {
    const float k = influences_;
    const float cosine = least_cosine > kCosineRounding ? least_cosine - kCosineRounding : 0;
    const float along = 1 / k + (1 - 1 / k) * cosine;
    const Float4 four = fold(products_);
    const float sum = (four[0] + four[1]) + (four[2] + four[3]);
    const float hull = dual_.product_sum * largest_squared;
    const float by_chords = 1 - (is_summed() && sum < hull ? sum : hull);
    const float n = along * along < by_chords ? by_chords : along * along;
    return n * (1 - 0x1p-10f) - 0x1p-14f;
  }

  DualShift finish(float largest_squared, float least_cosine) const {
    const float n = least_n(largest_squared, least_cosine);
    const Float4 stretch(kSecondOrder / n), products(dual_.product_sum), skews(dual_.skew_sum);
    Float4 low = products * least_of(sums_.hull_low), high = products * most_of(sums_.hull_high);
    Float4 swell = skews * most_of(sums_.hull_swell);
    if (is_summed()) {
      const Float4 rounding = Float4(0x1p-14f) * sum_of(sums_.size);
      low = max(low, sum_of(sums_.low) - rounding);
      high = min(high, sum_of(sums_.high) + rounding);
      swell = min(swell, sum_of(sums_.swell));
    }
    swell = Float4(std::sqrt(largest_squared)) * swell * stretch;
    constexpr float kUnit = 0x1p-24f * (1 + 0x1p-6f);
    return {min(low, low * stretch) - swell, max(high, high * stretch) + swell,
            (2.1f * influences_ / std::sqrt(n) + 60) * kUnit * palette_.extent()};
  }

  const NodeBounds& bounds_;
  const NodeBound& bound_;
  const DualBound& dual_;
  const Palette& palette_;
  float influences_;
  float slack_;  // rounding of the differences of images
  Sums sums_;
  Float8 products_ = zero(), largest_squared_ = zero();
  Float8 least_cosine_ = Float8(1.0f), most_other_cosine_ = Float8(-1.0f);  // |D|
};

/// Not inlined, so that models with linear blend skinning pay nothing.
[[gnu::noinline]] inline DualShift dual_shift(const NodeBounds& bounds, std::uint32_t node,
                                              const Palette& palette) {
  return DualShiftOf(bounds, node, palette).run();
}

/// Moves a box of linear blend skinning.
[[gnu::noinline]] inline Box4 dual_box(const NodeBounds& bounds, std::uint32_t node,
                                       const Palette& palette, const Box4& box) {
  const DualShift shift = dual_shift(bounds, node, palette);
  const Float4 margin(shift.margin), most((1 + 0x1p-12f) * palette.extent());
  return intersect({box.low + shift.low - margin, box.high + shift.high + margin},
                   {Float4(0.0f) - most, most});
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
