#pragma once

/// Evaluates what dual quaternion skinning adds to the box of a node; dual_bounds.hpp has the
/// formulas and their proof.

#include "model/node_bounds.hpp"
#include "model/rest_images.hpp"
#include "skin/dual_skin.hpp"

#include <cmath>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// The difference of a posed vertex from that of linear blend skinning is between low and high.
struct DualShift {
  float low[3], high[3];
  float margin;  ///< to add on every side
};

/// Computes the shift of one node.
class DualShiftOf {
 public:
  DualShiftOf(const NodeBounds& bounds, std::uint32_t node, const Palette& palette)
      : bounds_(bounds),
        bound_(bounds.nodes[node]),
        dual_(bounds.dual_bounds[node]),
        palette_(palette),
        joints_(bounds.joints.data() + bound_.first_joint) {}

  DualShift run() {
    find_angles();
    slack_ = 0x1p-18f * palette_.extent();
    const JointPair* const pairs = bounds_.joint_pairs.data() + dual_.first_pair;
    for (std::uint32_t i = 0; i < dual_.pair_count; ++i) add(pairs[i]);
    return finish();
  }

 private:
  static constexpr float kSecondOrder = 1 + 0x1p-14f;
  static constexpr float kCosineRounding = 0x1p-20f;

  struct Sums {
    float low = 0, high = 0;            // of the products
    float size = 0;                     // of their magnitudes
    float hull_low = 0, hull_high = 0;  // of all pairs and zero
    float swell = 0, hull_swell = 0;
  };

  const DualQuaternion& motion(std::uint16_t number) const {
    return palette_.duals().data()[joints_[number]];
  }

  float cosine(const JointPair& pair) const {
    return dot(rotation(pair.first), rotation(pair.second));
  }

  Dual<float> rotation(std::uint16_t number) const { return dual_of(motion(number)); }

  static float larger(float a, float b) { return a < b ? b : a; }
  static float smaller(float a, float b) { return a < b ? a : b; }

  static float squared_chord(float cosine) { return 2 * (1 - cosine) + kCosineRounding; }

  /// Finds the largest angles of two joints that share a vertex.
  void find_angles() {
    float least = 1, most_others = -1;
    const JointPair* const pairs = bounds_.joint_pairs.data() + dual_.first_pair;
    for (std::uint32_t i = 0; i < dual_.pair_count; ++i) {
      const float c = std::fabs(cosine(pairs[i]));
      least = smaller(least, c);
      if (pairs[i].with_pivot)
        least_with_pivot_ = smaller(least_with_pivot_, c);
      else
        most_others = larger(most_others, c), least_others_ = smaller(least_others_, c);
    }
    // Any pair is one with the pivot at some vertex.
    least_with_pivot_ = least;
    has_signs_ = least >= 0.5f + kCosineRounding;
    const float least_signed = has_signs_ ? least : smaller(least, -most_others);
    longest_chord_ = std::sqrt(squared_chord(least_signed));
  }

  void add(const JointPair& pair) {
    const Dual<float> a = rotation(pair.first), b = rotation(pair.second);
    const float c = dot(a, b), sign = c < 0 ? -1.0f : 1.0f;
    const bool has_sign = has_signs_ || pair.with_pivot != 0;
    const float squared = squared_chord(has_sign ? std::fabs(c) : -std::fabs(c));
    products_ += pair.most * squared;
    largest_squared_ = larger(largest_squared_, squared);
    const float swell = longest_chord_ * std::sqrt(squared);
    // The vector part of a b*.
    const float u[3] = {sign * (b.w * a.x - a.w * b.x - (a.y * b.z - a.z * b.y)),
                        sign * (b.w * a.y - a.w * b.y - (a.z * b.x - a.x * b.z)),
                        sign * (b.w * a.z - a.w * b.z - (a.x * b.y - a.y * b.x))};
    float way[4], reach[4];
    measure(pair, way, reach);
    for (int i = 0; i < 3; ++i) {
      const int j = i == 2 ? 0 : i + 1, k = i == 0 ? 2 : i - 1;
      const float middle = way[j] * u[k] - way[k] * u[j];
      const float half = reach[j] * std::fabs(u[k]) + reach[k] * std::fabs(u[j]) + slack_;
      const float far = std::fabs(middle) + half;
      add_axis(pair, has_sign ? middle - half : -far, has_sign ? middle + half : far, far,
               swell * (std::fabs(way[i]) + reach[i] + slack_), sums_[i]);
    }
  }

  static void add_axis(const JointPair& pair, float low, float high, float far, float swell,
                       Sums& sums) {
    sums.low += low < 0 ? pair.most * low : pair.least * low;
    sums.high += high > 0 ? pair.most * high : pair.least * high;
    sums.size += pair.most * far;
    sums.hull_low = smaller(sums.hull_low, low);
    sums.hull_high = larger(sums.hull_high, high);
    sums.swell += pair.skew * swell;
    sums.hull_swell = larger(sums.hull_swell, swell);
  }

  /// Finds the box of the differences of the images of the pair's rest box.
  void measure(const JointPair& pair, float (&way)[4], float (&reach)[4]) {
    const ColumnPairs difference =
        load_columns(palette_[joints_[pair.first]]) - load_columns(palette_[joints_[pair.second]]);
    if (!palette_.morphs().any()) return measure(difference, pair.centre, pair.half, way, reach);
    const std::size_t body = bound_.is_affine() ? bounds_.joint_boxes.size() + bound_.shape
                                                : bound_.first_record + pair.first;
    const BodyDisplacement displacement = displacement_of(bounds_, body, palette_.morphs());
    const JointBox box = displacement.displaced(pair.centre, pair.half);
    slack_ = 0x1p-18f * palette_.extent() * static_cast<float>(1 + displacement.target_count);
    measure(difference, box.centre, box.half, way, reach);
  }

  static void measure(const ColumnPairs& difference, const float* centre, const float* half,
                      float (&way)[4], float (&reach)[4]) {
    store4(way, fold(image(difference, centre)));
    store4(reach, fold(image(magnitudes(difference), half)));
  }

  /// A lower bound of n of all vertices of the node.
  float least_n() const {
    const float k = static_cast<float>(palette_.dual_influences());
    const float along = 1 / k + (1 - 1 / k) * larger(0, least_with_pivot_ - kCosineRounding);
    const float by_chords =
        1 - smaller(is_summed() ? products_ : 1, dual_.product_sum * largest_squared_);
    return larger(along * along, by_chords) * (1 - 0x1p-10f) - 0x1p-14f;
  }

  /// Sums over more pairs round too much.
  bool is_summed() const { return dual_.pair_count <= 200; }

  DualShift finish() const {
    DualShift shift;
    const float n = least_n(), stretch = kSecondOrder / n;
    for (int i = 0; i < 3; ++i) {
      const Sums& sums = sums_[i];
      const float swell = is_summed() ? smaller(sums.swell, dual_.skew_sum * sums.hull_swell)
                                      : dual_.skew_sum * sums.hull_swell;
      const float hull_low = dual_.product_sum * sums.hull_low;
      const float hull_high = dual_.product_sum * sums.hull_high;
      const float rounding = 0x1p-14f * sums.size;
      const float low = is_summed() ? larger(sums.low - rounding, hull_low) : hull_low;
      const float high = is_summed() ? smaller(sums.high + rounding, hull_high) : hull_high;
      shift.low[i] = smaller(low, low * stretch) - swell * stretch;
      shift.high[i] = larger(high, high * stretch) + swell * stretch;
    }
    const float k = static_cast<float>(palette_.dual_influences());
    constexpr float kUnit = 0x1p-24f * (1 + 0x1p-6f);
    shift.margin = (2.1f * k / std::sqrt(n) + 60) * kUnit * palette_.extent();
    return shift;
  }

  const NodeBounds& bounds_;
  const NodeBound& bound_;
  const DualBound& dual_;
  const Palette& palette_;
  const std::uint16_t* joints_;
  float least_with_pivot_ = 1, least_others_ = 1;  // |D|
  bool has_signs_ = true;                          // the signs of all D are known
  float longest_chord_ = 0;                        // s_max
  float slack_ = 0;                                // rounding of the differences of images
  float products_ = 0, largest_squared_ = 0;
  Sums sums_[3];
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
  const Float4 low(shift.low[0], shift.low[1], shift.low[2], 0);
  const Float4 high(shift.high[0], shift.high[1], shift.high[2], 0);
  return intersect({box.low + low - margin, box.high + high + margin}, {Float4(0.0f) - most, most});
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
