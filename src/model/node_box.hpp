#pragma once

/// Evaluates a node's bound on a palette; model/node_bounds.hpp has the formulas and their proof.

#include "geometry/box4.hpp"
#include "model/dual_box.hpp"
#include "model/node_bounds.hpp"
#include "model/rest_images.hpp"
#include "skin/palette.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// The columns t v_x, t v_y, t v_z and t v_w.
inline ColumnPairs outer_product(const Float4& t, const float* v) {
  const ColumnFactors factors = column_factors(v);
  return {factors.xy * Float8(t, t), factors.zw * Float8(t, t)};
}

/// `box_at(i)` is the rest box of joint i.
template <typename BoxAt>
inline Box4 joint_boxes_box(const NodeBounds& bounds, const NodeBound& bound, const BoxAt& box_at,
                            const Palette& palette) {
  const std::uint16_t* joint = bounds.joints.data() + bound.first_joint;
  Box4 all = empty_box();
  for (std::uint32_t i = 0; i < bound.joint_count; ++i, ++joint) {
    const ColumnPairs c = load_columns(palette[*joint]);
    const JointBox& box = box_at(i);
    const Float4 centre = fold(image(c, box.centre));
    const Float4 half = fold(image(magnitudes(c), box.half));
    all = unite(all, {centre - half, centre + half});
  }
  return all;
}

/// `centre` is the centre of the shape, or the displaced centre.
inline Box4 affine_box(const NodeBounds& bounds, const NodeBound& bound, const float* centre4,
                       const Palette& palette) {
  const std::uint16_t* joint = bounds.joints.data() + bound.first_joint;
  const JointFit* fit = bounds.fits.data() + bound.first_record;
  const RestShape& shape = bounds.shapes[bound.shape];
  const ColumnFactors rest_centre = column_factors(centre4);
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
    rest = rest + Float4(fit->residual()) * abs(t);
  }
  const ColumnPairs a = b + slope;  // the last column is meaningless and is multiplied by zero
  const Float4 centre = fold(image(b, rest_centre) + shift), excess = rest + fold(spread);
  const Float4 half = excess + fold(image(magnitudes(a), shape.half));
  const Float4 axes_half = excess + abs(fold(image(a, shape.axes[0]))) +
                           abs(fold(image(a, shape.axes[1]))) + abs(fold(image(a, shape.axes[2])));
  const Float4 axes_centre = centre + fold(image(a, shape.axes_centre));
  return intersect({centre - half, centre + half},
                   {axes_centre - axes_half, axes_centre + axes_half});
}

/// Largest image of a box around zero under the linear parts of the node's joints, on each axis.
inline Float4 largest_image(const NodeBounds& bounds, const NodeBound& bound, const float* half,
                            const Palette& palette) {
  const std::uint16_t* joint = bounds.joints.data() + bound.first_joint;
  Float4 largest(0.0f);
  for (std::uint32_t i = 0; i < bound.joint_count; ++i)
    largest = max(largest, fold(image(magnitudes(load_columns(palette[joint[i]])), half)));
  return largest;
}

/// A box and the margin to add to it.
struct LooseBox {
  Box4 box;
  Float4 margin;
};

inline Float4 morph_margin(std::uint32_t target_count) {
  constexpr float kRounding = 0x1p-24f * (1 + 0x1p-6f);
  return Float4(target_count == 0 ? 0 : static_cast<float>(2 * target_count + 8) * kRounding);
}

/// A joint's rest box displaced by active morph targets, and the additional margin.
struct MorphedJointBox {
  JointBox box;
  Float4 margin;
};

inline MorphedJointBox morphed_joint_box(const NodeBounds& bounds, const NodeBound& bound,
                                         std::uint32_t i, const Palette& palette) {
  const JointBox& rest = bounds.joint_boxes[bound.first_record + i];
  if (!palette.morphs().any()) return {rest, Float4(0.0f)};
  const BodyDisplacement displacement =
      displacement_of(bounds, bound.first_record + i, palette.morphs());
  return {displacement.displaced(rest.centre, rest.half),
          morph_margin(displacement.target_count) * Float4(palette.extent())};
}

inline LooseBox morphed_joint_boxes_box(const NodeBounds& bounds, const NodeBound& bound,
                                        const Palette& palette) {
  Float4 margin(0.0f);
  const auto box_at = [&](std::uint32_t i) {
    const MorphedJointBox morphed = morphed_joint_box(bounds, bound, i, palette);
    margin = max(margin, morphed.margin);
    return morphed.box;
  };
  const Box4 box = joint_boxes_box(bounds, bound, box_at, palette);
  return {box, margin};
}

inline LooseBox morphed_affine_box(const NodeBounds& bounds, const NodeBound& bound,
                                   const Palette& palette) {
  const RestShape& shape = bounds.shapes[bound.shape];
  const BodyDisplacement displacement =
      displacement_of(bounds, bounds.joint_boxes.size() + bound.shape, palette.morphs());
  if (displacement.target_count == 0)
    return {affine_box(bounds, bound, shape.centre, palette), Float4(0.0f)};
  const JointBox displaced = displacement.displaced(shape.centre, JointBox().half);
  return {affine_box(bounds, bound, displaced.centre, palette),
          morph_margin(displacement.target_count) * Float4(palette.extent()) +
              largest_image(bounds, bound, displaced.half, palette)};
}

/// Not inlined, so that models without morph targets pay nothing.
[[gnu::noinline]] inline LooseBox morphed_box(const NodeBounds& bounds, const NodeBound& bound,
                                              const Palette& palette) {
  return bound.is_affine() ? morphed_affine_box(bounds, bound, palette)
                           : morphed_joint_boxes_box(bounds, bound, palette);
}

/// Whether any target, active or not, displaces a vertex below the node.
inline bool has_displacements(const NodeBounds& bounds, const NodeBound& bound) {
  const std::size_t first =
      bound.is_affine() ? bounds.joint_boxes.size() + bound.shape : bound.first_record;
  const std::uint32_t* begin = bounds.displacement_begin.data() + first;
  return begin[0] != begin[bound.is_affine() ? 1 : bound.joint_count];
}

inline Box4 rest_box(const NodeBounds& bounds, const NodeBound& bound, const Palette& palette) {
  if (bound.is_affine())
    return affine_box(bounds, bound, bounds.shapes[bound.shape].centre, palette);
  const JointBox* boxes = bounds.joint_boxes.data() + bound.first_record;
  const auto box_at = [=](std::uint32_t i) -> const JointBox& { return boxes[i]; };
  return joint_boxes_box(bounds, bound, box_at, palette);
}

/// Widens the box of a node by its largest offset cap.
inline Box4 offset_box(const NodeBounds& bounds, std::uint32_t node, const Box4& box) {
  const Float4 cap(bounds.offset_caps[node]);
  return {box.low - cap, box.high + cap};
}

/// A box around every vertex below `node`, posed by linear blend skinning.
inline Box4 linear_box(const NodeBounds& bounds, std::uint32_t node, const Palette& palette) {
  const NodeBound& bound = bounds.nodes[node];
  const Float4 margin(bound.margin * palette.extent() + 0x1p-120f);
  if (palette.morphs().any() && has_displacements(bounds, bound)) {
    const LooseBox morphed = morphed_box(bounds, bound, palette);
    const Float4 more = margin + morphed.margin;
    return {morphed.box.low - more, morphed.box.high + more};
  }
  const Box4 box = rest_box(bounds, bound, palette);
  return {box.low - margin, box.high + margin};
}

/// A box around every posed vertex below `node`.
inline Box4 node_box(const NodeBounds& bounds, std::uint32_t node, const Palette& palette) {
  Box4 box = linear_box(bounds, node, palette);
  if (palette.is_dual()) box = dual_box(bounds, node, palette, box);
  return palette.offsets().empty() ? box : offset_box(bounds, node, box);
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
