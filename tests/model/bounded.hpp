#pragma once

/// Bounds of both kinds around many sets of a mesh's vertices, and checks that they enclose them.

#include "compiled_node_box.hpp"
#include "meshes.hpp"
#include "model/bound_fit.hpp"
#include "model/check_tree.hpp"
#include "model/node_bounds.hpp"
#include "model/tree_build.hpp"
#include "model/unpack.hpp"
#include "skin/skin.hpp"
#include "support/instruction_sets.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace pelt::test {

using detail::BoundKind;
using detail::NodeBounds;
using detail::Palette;
using detail::SkinnedMesh;
using detail::Tree;

/// Sets of vertices to bound, by their positions in the pools.
using VertexSets = std::vector<std::vector<std::uint32_t>>;

/// All vertices below each node of the tree. Also each vertex as a node of its own, whose margin
/// consists of rounding only, and sets of three, which are flat and oblique.
inline VertexSets nodes_and_a_few(const Tree& tree) {
  VertexSets sets(tree.nodes.size());
  for (std::size_t n = tree.nodes.size(); n-- > 0;) {
    const detail::Node& node = tree.nodes[n];
    for (std::uint32_t v = 0; v < node.vertex_count; ++v) sets[n].push_back(node.first_vertex + v);
    for (std::uint32_t c = node.first_child; c < node.first_child + node.child_count; ++c)
      sets[n].insert(sets[n].end(), sets[c].begin(), sets[c].end());
  }
  const auto count = static_cast<std::uint32_t>(tree.rest_positions.size());
  for (std::uint32_t v = 0; v < count; ++v) sets.push_back({v});
  for (std::uint32_t v = 2; v < count; ++v) sets.push_back({v - 2, v - 1, v});
  return sets;
}

/// Both kinds of bound for every set: joint boxes at 2 i, affine bounds at 2 i + 1.
inline NodeBounds fit_both_kinds(const Tree& tree, const VertexSets& sets) {
  const detail::WeightRounding rounding = weight_rounding(tree);
  detail::NodeVertices vertices(tree);
  NodeBounds bounds;
  const auto add_joints = [&](BoundKind kind, std::span<const std::uint16_t> joints,
                              std::size_t first_record, float margin) {
    bounds.nodes.push_back({.kind = kind,
                            .joint_count = static_cast<std::uint16_t>(joints.size()),
                            .first_joint = static_cast<std::uint32_t>(bounds.joints.size()),
                            .first_record = static_cast<std::uint32_t>(first_record),
                            .shape = static_cast<std::uint32_t>(bounds.shapes.size()),
                            .margin = margin});
    bounds.joints.insert(bounds.joints.end(), joints.begin(), joints.end());
  };
  for (const auto& set : sets) {
    vertices.assign(set);
    const detail::JointBoxesFit boxes = fit_joint_boxes(vertices, rounding);
    add_joints(BoundKind::joint_boxes, vertices.joints(), bounds.joint_boxes.size(), boxes.margin);
    bounds.joint_boxes.insert(bounds.joint_boxes.end(), boxes.boxes.begin(), boxes.boxes.end());
    const detail::AffineFit affine = fit_affine(vertices, rounding);
    add_joints(BoundKind::affine, affine.joints, bounds.fits.size(), affine.margin);
    bounds.fits.insert(bounds.fits.end(), affine.fits.begin(), affine.fits.end());
    bounds.shapes.push_back(affine.shape);
  }
  if (tree.morphs.extents.empty()) return bounds;
  detail::DisplacementFit displacements(tree);
  for (std::size_t n = 0; n < bounds.nodes.size(); ++n)
    displacements.add(bounds, bounds.nodes[n], sets[n / 2]);
  displacements.finish(bounds);
  return bounds;
}

/// A mesh with both kinds of bound around sets of its vertices.
struct Bounded {
  explicit Bounded(const SkinnedMesh& mesh)
      : tree(build_tree(mesh, rest_only(mesh))),
        vertices(unpack_vertices(tree)),
        sets(nodes_and_a_few(tree)),
        bounds(fit_both_kinds(tree, sets)),
        bare(bounds) {
    for (detail::NodeBound& bound : bare.nodes) bound.margin = 0;
  }

  explicit Bounded(const Shape& shape) : Bounded(mesh_of(shape)) {}

  Tree tree;
  SkinnedMesh vertices;  // in the order of the pools
  VertexSets sets;
  NodeBounds bounds, bare;  // with margins; without
};

inline PlainBox box_around(const std::vector<Vec3>& posed, const std::vector<std::uint32_t>& set) {
  PlainBox box = {{HUGE_VALF, HUGE_VALF, HUGE_VALF}, {-HUGE_VALF, -HUGE_VALF, -HUGE_VALF}};
  for (const std::uint32_t place : set) {
    const float p[] = {posed[place].x, posed[place].y, posed[place].z};
    for (int a = 0; a < 3; ++a) {
      box.low[a] = std::min(box.low[a], p[a]);
      box.high[a] = std::max(box.high[a], p[a]);
    }
  }
  return box;
}

inline bool encloses(const PlainBox& box, const PlainBox& exact) {
  for (int a = 0; a < 3; ++a)
    if (!(box.low[a] <= exact.low[a] && exact.high[a] <= box.high[a])) return false;
  return true;
}

/// The largest distance by which `exact` exceeds `box`.
inline double excess(const PlainBox& box, const PlainBox& exact) {
  double most = 0;
  for (int a = 0; a < 3; ++a) {
    most = std::max(most, double{box.low[a]} - double{exact.low[a]});
    most = std::max(most, double{exact.high[a]} - double{box.high[a]});
  }
  return most;
}

inline constexpr Compiled<NodeBoxFunction> kCompiledNodeBoxes[] =
    PELT_ALL_COMPILED(compiled_node_box);

inline PlainBox node_box(const NodeBounds& bounds, std::uint32_t node, const Palette& palette) {
  return scalar::compiled_node_box(bounds, node, palette);
}

inline std::vector<Vec3> pose(const SkinnedMesh& vertices, const Palette& palette) {
  std::vector<Vec3> posed(vertices.rest_positions.size());
  for (std::uint32_t v = 0; v < posed.size(); ++v)
    posed[v] = pelt::scalar::posed_vertex(vertices, palette, v);
  return posed;
}

inline const char* name_of(BoundKind kind) {
  return kind == BoundKind::affine ? "affine" : "joint boxes";
}

/// Counts of checks, and the used fraction of the margins.
struct Tally {
  std::size_t boxes = 0;
  double largest_share = 0;  // largest used fraction of a margin
  double units_needed = 0;   // in u M
};

/// Adds the fraction of the margin that the posed vertices need.
inline void add_margin_needed(const Bounded& bounded, std::uint32_t node, const Palette& palette,
                              const PlainBox& exact, Tally& tally) {
  const double need = excess(node_box(bounded.bare, node, palette), exact);
  const double margin{bounded.bounds.nodes[node].margin}, extent{palette.extent()};
  tally.largest_share = std::max(tally.largest_share, need / (margin * extent));
  tally.units_needed = std::max(tally.units_needed, need / (0x1p-24 * extent));
}

inline bool is_finite(const PlainBox& box) {
  return std::all_of(box.low, box.low + 3, [](float c) { return std::isfinite(c); }) &&
         std::all_of(box.high, box.high + 3, [](float c) { return std::isfinite(c); });
}

/// Whether a build could use this bound.
inline bool is_usable(const Bounded& bounded, const detail::NodeBound& bound) {
  return !bound.is_affine() ||
         detail::stays_finite(
             {bounded.bounds.fits.data() + bound.first_record, bound.record_count()}, bound.margin,
             bounded.tree.rest_extent);
}

/// Checks both kinds of bound around every set of vertices on every instruction set. Stops at the
/// first failure.
inline void expect_enclosed(const Bounded& bounded, const Palette& palette, Tally& tally) {
  const std::vector<Vec3> posed = pose(bounded.vertices, palette);
  for (std::uint32_t node = 0; node < bounded.bounds.nodes.size(); ++node) {
    const auto& set = bounded.sets[node / 2];
    const PlainBox exact = box_around(posed, set);
    const PlainBox box = node_box(bounded.bounds, node, palette);
    ASSERT_TRUE(encloses(box, exact))
        << name_of(bounded.bounds.nodes[node].kind) << " around " << set.size()
        << " vertices leave out one by " << excess(box, exact);
    ASSERT_TRUE(is_finite(box) || !is_usable(bounded, bounded.bounds.nodes[node]));
    for (const auto& compiled : kCompiledNodeBoxes) {
      if (!runs_here(compiled.set)) continue;
      ASSERT_EQ(compiled.call(bounded.bounds, node, palette), box) << pelt::name_of(compiled.set);
    }
    add_margin_needed(bounded, node, palette, exact, tally);
    ++tally.boxes;
  }
}

inline void expect_enclosed(const Bounded& bounded, const std::vector<Matrix4>& matrices,
                            Tally& tally) {
  Palette palette = rest_palette(bounded.tree);
  const auto taken = palette.set(matrices);
  ASSERT_TRUE(taken) << taken.error().message;
  expect_enclosed(bounded, palette, tally);
}

inline Matrix4 scaled(Matrix4 joint, float x, float y, float z) {
  for (std::size_t row = 0; row < 3; ++row)
    joint.m[row] *= x, joint.m[4 + row] *= y, joint.m[8 + row] *= z;
  return joint;
}

/// Palettes of every kind: rigid, affine, collapsed, far away, mirrored, scaled down, scaled up,
/// with joints far apart, with equal joints, and the rest pose.
inline std::vector<std::vector<Matrix4>> palettes_of_all_kinds(Random& random,
                                                               std::uint32_t joint_count) {
  std::vector<std::vector<Matrix4>> all;
  for (const Motion motion : {Motion::rigid, Motion::affine, Motion::collapsed, Motion::far_away})
    all.push_back(make_palette(random, joint_count, motion, 2));
  const auto rigid = [&] { return make_palette(random, joint_count, Motion::rigid, 2); };
  const auto add_scaled = [&](float x, float y, float z) {
    all.push_back(rigid());
    for (Matrix4& joint : all.back()) joint = scaled(joint, x, y, z);
  };
  add_scaled(-1, 1, 1);
  add_scaled(-3, -3, -3);
  add_scaled(1e-6f, 1e-6f, 1e-6f);
  add_scaled(1e6f, 1, 1e-6f);
  add_scaled(0, 0, 0);
  all.push_back(make_palette(random, joint_count, Motion::rigid, 1e5));
  all.push_back(make_palette(random, joint_count, Motion::affine, 1e5));
  all.push_back(std::vector<Matrix4>(joint_count, rigid()[0]));
  all.push_back(std::vector<Matrix4>(joint_count));
  return all;
}

inline void expect_enclosed_in_all_poses(Random& random, const Shape& shape, Tally& tally) {
  const Bounded bounded(shape);
  for (const auto& palette : palettes_of_all_kinds(random, shape.joint_count)) {
    expect_enclosed(bounded, palette, tally);
    if (::testing::Test::HasFatalFailure()) return;
  }
}

inline void report(const Tally& tally) {
  std::printf("%zu boxes, at most %.2f u M of margin needed, %.3f of what there was\n", tally.boxes,
              tally.units_needed, tally.largest_share);
}

}  // namespace pelt::test
