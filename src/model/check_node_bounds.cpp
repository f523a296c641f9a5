#include "model/check_tree.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pelt::detail {
namespace {

/// Far larger than any fitted margin, and finite if multiplied by the extent of a palette.
constexpr float kMaxMargin = 0x1p28f;

/// Size of the mesh as palettes define it.
double mesh_size(float rest_extent) { return double{std::max(rest_extent, kLeastRestExtent)}; }

double sum_of_magnitudes(const float* v) {
  return std::fabs(double{v[0]}) + std::fabs(double{v[1]}) + std::fabs(double{v[2]});
}

/// The comparisons are false for NaN.
bool is_within(const float (&v)[4], double limit, float fourth) {
  return std::fabs(v[0]) <= limit && std::fabs(v[1]) <= limit && std::fabs(v[2]) <= limit &&
         v[3] == fourth;
}

bool is_point_within(const float (&v)[4], double limit) { return is_within(v, limit, 1); }
bool is_vector_within(const float (&v)[4], double limit) { return is_within(v, limit, 0); }

bool is_half_within(const float (&v)[4], double limit) {
  return is_vector_within(v, limit) && v[0] >= 0 && v[1] >= 0 && v[2] >= 0;
}

/// Whether a number can be a product of weights that sum to one, or a sum of products.
bool is_share(float number) { return number >= 0 && number <= 0.5f; }

class BoundsCheck {
 public:
  BoundsCheck(const NodeBounds& bounds, const Tree& tree)
      : bounds_(bounds), tree_(tree), reach_(4 * mesh_size(tree.rest_extent)) {}

  /// Later checks rely on the earlier ones.
  Problem run() {
    for (const auto check :
         {&BoundsCheck::check_nodes, &BoundsCheck::check_joints, &BoundsCheck::check_joint_boxes,
          &BoundsCheck::check_shapes, &BoundsCheck::check_fits,
          &BoundsCheck::check_displacement_begin, &BoundsCheck::check_displacements,
          &BoundsCheck::check_links, &BoundsCheck::check_dual_bounds})
      if (Problem found = (this->*check)(); !found.empty()) return found;
    return {};
  }

 private:
  Problem check_nodes();
  Problem check_node(std::size_t n);
  Problem check_joints();
  Problem check_joint_boxes();
  Problem check_shapes();
  Problem check_fits();
  Problem check_displacement_begin();
  Problem check_displacements();
  Problem check_links();
  Problem check_dual_bounds();
  Problem check_joint_pairs(std::size_t n);

  const NodeBounds& bounds_;
  const Tree& tree_;
  double reach_;  // largest allowed distance of a shape from the origin
};

/// Checks by the counts that every element of every array belongs to one node. The work of
/// evaluating all nodes is then proportional to the size of the arrays.
Problem BoundsCheck::check_nodes() {
  if (bounds_.nodes.size() != tree_.nodes.size())
    return problem("bounds has %zu nodes, but the tree %zu", bounds_.nodes.size(),
                   tree_.nodes.size());
  std::size_t joints = 0, boxes = 0, shapes = 0, fits = 0;
  for (std::size_t n = 0; n < bounds_.nodes.size(); ++n) {
    if (Problem found = check_node(n); !found.empty()) return found;
    const NodeBound& bound = bounds_.nodes[n];
    joints += bound.joint_count;
    (bound.is_affine() ? fits : boxes) += bound.record_count();
    shapes += bound.is_affine();
  }
  if (joints != bounds_.joints.size() || boxes != bounds_.joint_boxes.size() ||
      shapes != bounds_.shapes.size() || fits != bounds_.fits.size())
    return problem(
        "bounds.nodes have %zu joints of %zu, %zu joint_boxes of %zu, %zu shapes of %zu, %zu fits "
        "of %zu",
        joints, bounds_.joints.size(), boxes, bounds_.joint_boxes.size(), shapes,
        bounds_.shapes.size(), fits, bounds_.fits.size());
  return {};
}

Problem BoundsCheck::check_node(std::size_t n) {
  const NodeBound& bound = bounds_.nodes[n];
  if (bound.kind != BoundKind::joint_boxes && bound.kind != BoundKind::affine)
    return problem("bounds.nodes[%zu].kind is %u", n, static_cast<unsigned>(bound.kind));
  if (bound.joint_count == 0) return problem("bounds.nodes[%zu] has no joints", n);
  const std::size_t records = bound.is_affine() ? bounds_.fits.size() : bounds_.joint_boxes.size();
  if (std::size_t{bound.first_joint} + bound.joint_count > bounds_.joints.size() ||
      std::size_t{bound.first_record} + bound.record_count() > records ||
      (bound.is_affine() && bound.shape >= bounds_.shapes.size()))
    return problem("bounds.nodes[%zu] reaches beyond the end of an array", n);
  if (!(bound.margin >= 0 && bound.margin <= kMaxMargin))
    return problem("bounds.nodes[%zu].margin is %g", n, static_cast<double>(bound.margin));
  if (bound.is_affine() &&
      !stays_finite({bounds_.fits.data() + bound.first_record, bound.record_count()}, bound.margin,
                    tree_.rest_extent))
    return problem("bounds.nodes[%zu] can become infinite", n);
  return {};
}

Problem BoundsCheck::check_joints() {
  for (std::size_t i = 0; i < bounds_.joints.size(); ++i)
    if (bounds_.joints[i] >= tree_.joint_count)
      return problem("bounds.joints[%zu] is %u, but joint_count is %u", i, bounds_.joints[i],
                     tree_.joint_count);
  return {};
}

Problem BoundsCheck::check_joint_boxes() {
  for (std::size_t i = 0; i < bounds_.joint_boxes.size(); ++i)
    if (const JointBox& box = bounds_.joint_boxes[i];
        !is_point_within(box.centre, reach_) || !is_half_within(box.half, reach_))
      return problem("bounds.joint_boxes[%zu] is not a box within the mesh", i);
  return {};
}

Problem BoundsCheck::check_shapes() {
  for (std::size_t i = 0; i < bounds_.shapes.size(); ++i)
    if (const RestShape& shape = bounds_.shapes[i];
        !is_point_within(shape.centre, reach_) || !is_half_within(shape.half, reach_) ||
        !is_vector_within(shape.axes_centre, reach_) || !is_vector_within(shape.axes[0], reach_) ||
        !is_vector_within(shape.axes[1], reach_) || !is_vector_within(shape.axes[2], reach_))
      return problem("bounds.shapes[%zu] is not a shape within the mesh", i);
  return {};
}

/// The magnitudes were checked by stays_finite.
Problem BoundsCheck::check_fits() {
  for (std::size_t i = 0; i < bounds_.fits.size(); ++i) {
    const JointFit& fit = bounds_.fits[i];
    if (fit.shift[3] != 0) return problem("bounds.fits[%zu] has a shift of four components", i);
    for (const float half : fit.spread)
      if (!(half >= 0)) return problem("bounds.fits[%zu] has a negative half extent", i);
  }
  return {};
}

/// Checks by the counts that every displacement box belongs to one rest body.
Problem BoundsCheck::check_displacement_begin() {
  const auto& begin = bounds_.displacement_begin;
  const std::size_t bodies = bounds_.joint_boxes.size() + bounds_.shapes.size();
  const std::size_t expected = tree_.morphs.extents.empty() ? 0 : bodies + 1;
  if (begin.size() != expected)
    return problem("bounds.displacement_begin has %zu elements, expected %zu", begin.size(),
                   expected);
  const std::size_t last = begin.empty() ? 0 : begin.back();
  if (last != bounds_.displacements.size() || !std::is_sorted(begin.begin(), begin.end()))
    return problem("bounds.displacement_begin does not ascend to %zu",
                   bounds_.displacements.size());
  std::size_t boxes = 0;
  for (const NodeBound& bound : bounds_.nodes) {
    if (begin.empty()) break;
    const std::size_t body =
        bound.is_affine() ? bounds_.joint_boxes.size() + bound.shape : bound.first_record;
    boxes += begin[body + (bound.is_affine() ? 1 : bound.joint_count)] - begin[body];
  }
  if (boxes == bounds_.displacements.size()) return {};
  return problem("bounds.nodes have %zu displacements of %zu", boxes, bounds_.displacements.size());
}

Problem BoundsCheck::check_displacements() {
  for (std::size_t body = 0; body + 1 < bounds_.displacement_begin.size(); ++body) {
    const std::uint32_t first = bounds_.displacement_begin[body];
    for (std::uint32_t i = first; i < bounds_.displacement_begin[body + 1]; ++i) {
      const DisplacementBox& box = bounds_.displacements[i];
      if (box.target >= tree_.morphs.extents.size() ||
          (i > first && box.target <= bounds_.displacements[i - 1].target))
        return problem("bounds.displacements[%u] is of target %u, out of order or of range", i,
                       box.target);
      const double reach = 4 * double{tree_.morphs.extents[box.target]};
      if (!is_vector_within(box.centre, reach) || !is_half_within(box.half, reach))
        return problem("bounds.displacements[%u] is not a box of displacements", i);
    }
  }
  return {};
}

Problem BoundsCheck::check_links() {
  const std::vector<JointLink>& links = tree_.links;
  if (tree_.dual_influences == 0 && !links.empty())
    return problem("links has %zu elements with linear blend skinning", links.size());
  for (std::size_t i = 0; i < links.size(); ++i) {
    const JointLink& link = links[i];
    if (link.first >= link.second || link.second >= tree_.joint_count)
      return problem("links[%zu] has the joints %u and %u of %u", i, link.first, link.second,
                     tree_.joint_count);
    if (i > 0 && !(joints_of(links[i - 1]) < joints_of(link)))
      return problem("links[%zu] does not ascend", i);
    if (!is_point_within(link.centre, reach_) || !is_half_within(link.half, reach_))
      return problem("links[%zu] is not a box within the mesh", i);
  }
  return {};
}

/// Checks that the pairs of each node follow those of the node before, as fitting stores them,
/// children first.
Problem BoundsCheck::check_dual_bounds() {
  const std::size_t expected = tree_.dual_influences > 0 ? bounds_.nodes.size() : 0;
  if (bounds_.dual_bounds.size() != expected)
    return problem("bounds.dual_bounds has %zu elements, expected %zu", bounds_.dual_bounds.size(),
                   expected);
  std::size_t pairs = 0;
  for (std::size_t n = expected; n-- > 0;) {
    const DualBound& dual = bounds_.dual_bounds[n];
    if (dual.first_pair != pairs || dual.pair_count > bounds_.joint_pairs.size() - pairs)
      return problem("bounds.dual_bounds[%zu] has other joint_pairs than its own", n);
    if (!is_share(dual.product_sum) || !is_share(dual.skew_sum))
      return problem("bounds.dual_bounds[%zu] has sums of %g and %g", n, double{dual.product_sum},
                     double{dual.skew_sum});
    if (Problem found = check_joint_pairs(n); !found.empty()) return found;
    pairs += dual.pair_count;
  }
  if (pairs == bounds_.joint_pairs.size()) return {};
  return problem("bounds.dual_bounds have %zu joint_pairs of %zu", pairs,
                 bounds_.joint_pairs.size());
}

Problem BoundsCheck::check_joint_pairs(std::size_t n) {
  const DualBound& dual = bounds_.dual_bounds[n];
  const NodeBound& bound = bounds_.nodes[n];
  const std::uint16_t* joints = bounds_.joints.data() + bound.first_joint;
  for (std::size_t i = dual.first_pair; i < std::size_t{dual.first_pair} + dual.pair_count; ++i) {
    const JointPair& pair = bounds_.joint_pairs[i];
    if (pair.link >= tree_.links.size())
      return problem("bounds.joint_pairs[%zu].link is %u of %zu", i, pair.link, tree_.links.size());
    if (pair.first >= bound.joint_count || joints[pair.first] != tree_.links[pair.link].first)
      return problem("bounds.joint_pairs[%zu].first is not the first joint of its link", i);
    if (!is_share(pair.least) || !is_share(pair.most) || !is_share(pair.skew))
      return problem("bounds.joint_pairs[%zu] has impossible products of weights", i);
    if (pair.pivot != 0 && pair.pivot != 1)
      return problem("bounds.joint_pairs[%zu].pivot is %g", i, double{pair.pivot});
    if (!is_point_within(pair.centre, reach_) || !is_half_within(pair.half, reach_))
      return problem("bounds.joint_pairs[%zu] is not a box within the mesh", i);
  }
  return {};
}

}  // namespace

Problem check_node_bounds(const NodeBounds& bounds, const Tree& tree) {
  return BoundsCheck(bounds, tree).run();
}

bool stays_finite(std::span<const JointFit> fits, float margin, float rest_extent) {
  const double mesh = mesh_size(rest_extent);
  double q = 0;
  for (const JointFit& fit : fits)
    q += std::fabs(double{fit.mean()}) + mesh * sum_of_magnitudes(fit.line) +
         std::fabs(double{fit.residual()}) +
         (sum_of_magnitudes(fit.shift) + sum_of_magnitudes(fit.spread)) / mesh;
  return 1 + q <= std::min(0x1p54, 0x1p60 * mesh) && margin <= kMaxMargin;
}

}  // namespace pelt::detail
