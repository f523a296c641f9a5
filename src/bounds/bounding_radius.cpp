/// A posed vertex is a convex combination of its images under single joints, and each image is in
/// the moved rest box of its joint. Its distance from a point is therefore at most that of the
/// farthest vertex of these boxes (node_bounds.hpp has the rounding of the boxes). The vertex of a
/// box with centre p and half extents h that is farthest from c has the distances |p - c| + h along
/// the axes.
///
/// Rounding. With six roundings on each axis, including that of the margin, five for squares and
/// sums, and one for the root, the error is at most 13 u of the radius, where u = 2^-24; the radius
/// is increased by 16 u. A square that underflows has an error of at most 2^-149, far below 2^-100.
/// A square that overflows makes the radius infinite, which is still a bound.
///
/// Offsets. A posed vertex is then a convex combination of its images, each moved by the same
/// offset of at most c on each axis, so the boxes grow by c. The sum of vertex and offset has one
/// more rounding, of at most u (M + c).

#include "bounds/bounding_radius.hpp"

#include "model/node_box.hpp"

#include <cmath>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

namespace {

/// Returns an upper bound of how far dual quaternion skinning moves a vertex away from where linear
/// blend skinning moves it.
float longest_shift(const NodeBounds& bounds, const Palette& palette) {
  const DualShift shift = dual_shift(bounds, 0, palette, Float4(0.0f));
  float squared = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const float below = shift.down_up.low()[axis], above = shift.down_up.high()[axis];
    const float most = (below > above ? below : above) + shift.margin;
    squared += most * most;
  }
  return std::sqrt(squared + 0x1p-100f) * (1 + 0x1p-20f);
}

}  // namespace

float bounding_radius(const NodeBounds& bounds, const Palette& palette, const float* centre) {
  const NodeBound& root = bounds.nodes[0];
  if (root.is_affine()) return HUGE_VALF;
  const std::uint16_t* joint = bounds.joints.data() + root.first_joint;
  const JointBox* box = bounds.joint_boxes.data() + root.first_record;
  const float cap = palette.offsets().empty() ? 0 : bounds.offset_caps[0];
  const Float4 from = load4(centre);
  const Float4 margin((root.margin + (cap > 0 ? 0x1p-23f : 0)) * palette.extent() +
                      cap * (1 + 0x1p-21f) + 0x1p-120f);
  float farthest = 0;
  const bool morphed = palette.morphs().any();
  for (std::uint32_t i = 0; i < root.joint_count; ++i, ++joint, ++box) {
    const ColumnPairs c = load_columns(palette[*joint]);
    const MorphedJointBox moved =
        morphed ? morphed_joint_box(bounds, root, i, palette) : MorphedJointBox{};
    const JointBox& rest = morphed ? moved.box : *box;
    const Float4 middle = fold(image(c, rest.centre));
    const Float4 half = fold(image(magnitudes(c), rest.half));
    const Float4 reach = morphed ? half + margin + moved.margin : half + margin;
    const Float4 away = abs(middle - from) + reach, squares = away * away;
    const float distance = squares[0] + squares[1] + squares[2];
    farthest = distance > farthest ? distance : farthest;
  }
  const float radius = std::sqrt(farthest + 0x1p-100f) * (1 + 0x1p-20f);
  return palette.is_dual() ? radius + longest_shift(bounds, palette) : radius;
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail
