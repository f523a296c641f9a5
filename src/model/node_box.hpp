#pragma once

/// A node's bound evaluated on a palette; model/node_bounds.hpp has the formulas and their proof.

#include "base/float8.hpp"
#include "model/node_bounds.hpp"
#include "skin/palette.hpp"

namespace pelt::detail {
inline namespace PELT_TARGET {

/// Corners of a box; the fourth lanes are meaningless.
struct Box4 {
  Float4 low, high;
};

inline Box4 unite(const Box4& a, const Box4& b) { return {min(a.low, b.low), max(a.high, b.high)}; }
inline Box4 intersect(const Box4& a, const Box4& b) {
  return {max(a.low, b.low), min(a.high, b.high)};
}

/// Columns of a 3 x 4 matrix, two by two.
struct ColumnPairs {
  Float8 xy, zt;
};

inline ColumnPairs load_columns(const Matrix4& m) {
  return {load8(m.m.data()), load8(m.m.data() + 8)};
}

/// The columns times x, y, z and `w`, still in two shares that `fold` adds up.
inline Float8 image(const ColumnPairs& m, const float* v, float w) {
  return pair8(v[0], v[1]) * m.xy + pair8(v[2], w) * m.zt;
}

inline ColumnPairs magnitudes(const ColumnPairs& m) { return {abs(m.xy), abs(m.zt)}; }

inline Box4 joint_boxes_box(const NodeBounds& bounds, const NodeBound& bound,
                            const Palette& palette) {
  const std::uint16_t* joint = bounds.joints.data() + bound.first_joint;
  const JointBox* box = bounds.joint_boxes.data() + bound.first_record;
  Box4 all{Float4(HUGE_VALF), Float4(-HUGE_VALF)};
  for (std::uint32_t i = 0; i < bound.joint_count; ++i, ++joint, ++box) {
    const ColumnPairs c = load_columns(palette[*joint]);
    const Float4 centre = fold(image(c, box->centre, 1));
    const Float4 half = fold(image(magnitudes(c), box->half, 0));
    all = unite(all, {centre - half, centre + half});
  }
  return all;
}

/// The mean matrix B.
inline ColumnPairs mean_columns(const std::uint16_t* joints, const JointFit* fits,
                                std::uint32_t count, const Palette& palette) {
  ColumnPairs mean{Float8(0.0f), Float8(0.0f)};
  for (std::uint32_t i = 0; i < count; ++i) {
    const ColumnPairs c = load_columns(palette[joints[i]]);
    const Float8 weight(fits[i].mean);
    mean = {mean.xy + weight * c.xy, mean.zt + weight * c.zt};
  }
  return mean;
}

inline Box4 affine_box(const NodeBounds& bounds, const NodeBound& bound, const Palette& palette) {
  const std::uint16_t* joints = bounds.joints.data() + bound.first_joint;
  const JointFit* fits = bounds.fits.data() + bound.first_record;
  const RestShape& shape = bounds.shapes[bound.shape];
  const ColumnPairs b = mean_columns(joints, fits, bound.joint_count, palette);
  ColumnPairs a = b;
  Float8 centre_shares = image(b, shape.centre, 1), spread_shares(0.0f);
  Float4 rest(0.0f);
  for (std::uint32_t i = 0; i < bound.joint_count; ++i) {
    const JointFit& fit = fits[i];
    const ColumnPairs c = load_columns(palette[joints[i]]);
    const ColumnPairs d{c.xy - b.xy, c.zt - b.zt};
    const Float4 t = fold(image(d, shape.centre, 1));
    const Float8 tt(t, t);
    a = {a.xy + tt * pair8(fit.gradient[0], fit.gradient[1]),
         a.zt + tt * pair8(fit.gradient[2], 0)};
    centre_shares = centre_shares + image(d, fit.shift, 0);
    spread_shares = spread_shares + image(magnitudes(d), fit.spread, 0);
    rest = rest + Float4(fit.rest) * abs(t);
  }
  const Float4 centre = fold(centre_shares), excess = rest + fold(spread_shares);
  const Float4 half = excess + fold(image(magnitudes(a), shape.half, 0));
  const Float4 axes_half = excess + abs(fold(image(a, shape.axes[0], 0))) +
                           abs(fold(image(a, shape.axes[1], 0))) +
                           abs(fold(image(a, shape.axes[2], 0)));
  const Float4 axes_centre = centre + fold(image(a, shape.axes_centre, 0));
  return intersect({centre - half, centre + half},
                   {axes_centre - axes_half, axes_centre + axes_half});
}

/// A box around every posed vertex below `node`.
inline Box4 node_box(const NodeBounds& bounds, std::uint32_t node, const Palette& palette) {
  const NodeBound& bound = bounds.nodes[node];
  const Box4 box = bound.kind == BoundKind::affine ? affine_box(bounds, bound, palette)
                                                   : joint_boxes_box(bounds, bound, palette);
  const Float4 margin(bound.margin * palette.extent() + 0x1p-120f);
  return {box.low - margin, box.high + margin};
}

}  // namespace PELT_TARGET
}  // namespace pelt::detail
