#pragma once

/// A node's bound evaluated on a palette; model/node_bounds.hpp has the formulas and their proof.

#include "base/float8.hpp"
#include "geometry/box4.hpp"
#include "model/node_bounds.hpp"
#include "skin/palette.hpp"

namespace pelt::detail {
inline namespace PELT_TARGET {

/// Columns of a 3 x 4 matrix, two by two.
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

/// The columns times the factors, still in two shares that `fold` adds up.
inline Float8 image(const ColumnPairs& m, const ColumnFactors& v) {
  return v.xy * m.xy + v.zw * m.zt;
}
inline Float8 image(const ColumnPairs& m, const float* v) { return image(m, column_factors(v)); }

/// The columns t v_x, t v_y, t v_z and t v_w.
inline ColumnPairs outer_product(const Float4& t, const float* v) {
  const ColumnFactors factors = column_factors(v);
  return {factors.xy * Float8(t, t), factors.zw * Float8(t, t)};
}

inline Box4 joint_boxes_box(const NodeBounds& bounds, const NodeBound& bound,
                            const Palette& palette) {
  const std::uint16_t* joint = bounds.joints.data() + bound.first_joint;
  const JointBox* box = bounds.joint_boxes.data() + bound.first_record;
  Box4 all = empty_box();
  for (std::uint32_t i = 0; i < bound.joint_count; ++i, ++joint, ++box) {
    const ColumnPairs c = load_columns(palette[*joint]);
    const Float4 centre = fold(image(c, box->centre));
    const Float4 half = fold(image(magnitudes(c), box->half));
    all = unite(all, {centre - half, centre + half});
  }
  return all;
}

inline Box4 affine_box(const NodeBounds& bounds, const NodeBound& bound, const Palette& palette) {
  const std::uint16_t* joint = bounds.joints.data() + bound.first_joint;
  const JointFit* fit = bounds.fits.data() + bound.first_record;
  const RestShape& shape = bounds.shapes[bound.shape];
  const ColumnFactors rest_centre = column_factors(shape.centre);
  const ColumnPairs reference = load_columns(palette[*joint]);
  ColumnPairs b = reference, slope{Float8(0.0f), Float8(0.0f)};
  Float8 shift(0.0f), spread(0.0f);
  Float4 rest(0.0f);
  for (std::uint32_t i = 1; i < bound.joint_count; ++i, ++fit) {
    const ColumnPairs d = load_columns(palette[joint[i]]) - reference;
    const Float4 t = fold(image(d, rest_centre));
    b = b + fit->mean() * d;
    slope = slope + outer_product(t, fit->line);
    shift = shift + image(d, fit->shift);
    spread = spread + image(magnitudes(without_translation(d)), fit->spread);
    rest = rest + Float4(fit->rest()) * abs(t);
  }
  const ColumnPairs a = b + slope;  // its last column is meaningless, and multiplied by zero
  const Float4 centre = fold(image(b, rest_centre) + shift), excess = rest + fold(spread);
  const Float4 half = excess + fold(image(magnitudes(a), shape.half));
  const Float4 axes_half = excess + abs(fold(image(a, shape.axes[0]))) +
                           abs(fold(image(a, shape.axes[1]))) + abs(fold(image(a, shape.axes[2])));
  const Float4 axes_centre = centre + fold(image(a, shape.axes_centre));
  return intersect({centre - half, centre + half},
                   {axes_centre - axes_half, axes_centre + axes_half});
}

/// A box around every posed vertex below `node`.
inline Box4 node_box(const NodeBounds& bounds, std::uint32_t node, const Palette& palette) {
  const NodeBound& bound = bounds.nodes[node];
  const Box4 box = bound.is_affine() ? affine_box(bounds, bound, palette)
                                     : joint_boxes_box(bounds, bound, palette);
  const Float4 margin(bound.margin * palette.extent() + 0x1p-120f);
  return {box.low - margin, box.high + margin};
}

}  // namespace PELT_TARGET
}  // namespace pelt::detail
