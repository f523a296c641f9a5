#pragma once

/// Images of rest positions and rest boxes under joint matrices, and boxes of displacements.

#include "base/float8.hpp"
#include "model/node_bounds.hpp"
#include "model/tree.hpp"
#include "skin/palette.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Columns of a 3 x 4 matrix, in pairs.
struct ColumnPairs {
  Float8 xy, zt;
};

inline ColumnPairs load_columns(const Matrix4& m) {
  return {load8(m.m.data()), load8(m.m.data() + 8)};
}

inline ColumnPairs operator+(const ColumnPairs& a, const ColumnPairs& b) {
  return {a.xy + b.xy, a.zt + b.zt};
}
inline ColumnPairs operator-(const ColumnPairs& a, const ColumnPairs& b) {
  return {a.xy - b.xy, a.zt - b.zt};
}
inline ColumnPairs operator*(float s, const ColumnPairs& m) {
  return {Float8(s) * m.xy, Float8(s) * m.zt};
}

inline ColumnPairs magnitudes(const ColumnPairs& m) { return {abs(m.xy), abs(m.zt)}; }

inline ColumnPairs without_translation(const ColumnPairs& m) {
  return {m.xy, Float8(m.zt.low(), Float4(0.0f))};
}

/// The columns times the factors, as two partial sums that `fold` adds.
inline Float8 image(const ColumnPairs& m, const ColumnFactors& v) {
  return v.xy * m.xy + v.zw * m.zt;
}
inline Float8 image(const ColumnPairs& m, const float* v) { return image(m, column_factors(v)); }

/// Box of the displacement of a rest body's vertices by the active morph targets.
struct BodyDisplacement {
  Float4 centre, half;
  std::uint32_t target_count;

  JointBox displaced(const float* rest_centre, const float* rest_half) const {
    JointBox box;
    store4(box.centre, load4(rest_centre) + centre);
    store4(box.half, load4(rest_half) + half);
    return box;
  }
};

inline BodyDisplacement displacement_of(const NodeBounds& bounds, std::size_t body,
                                        const MorphWeights& morphs) {
  BodyDisplacement sum = {Float4(0.0f), Float4(0.0f), 0};
  const std::uint32_t* begin = bounds.displacement_begin.data() + body;
  const DisplacementBox* boxes = bounds.displacements.data();
  each_active(boxes + begin[0], boxes + begin[1], morphs, [&](const DisplacementBox& box) {
    const Float4 weight(morphs[box.target]);
    sum.centre = sum.centre + weight * load4(box.centre);
    sum.half = sum.half + abs(weight) * load4(box.half);
    ++sum.target_count;
  });
  return sum;
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
