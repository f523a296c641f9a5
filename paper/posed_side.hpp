#pragma once

#include "geometry/triangle_pair.hpp"
#include "paper/ball.hpp"
#include "paper/sphere_tree.hpp"

#include <span>

namespace pelt::paper {

using detail::TriangleCorners;

/// An operand of a descent whose spheres and vertices have been computed before.
class PosedSide {
 public:
  PosedSide(const SphereTree& tree, std::span<const Float4> spheres,
            std::span<const Triangle> triangles, std::span<const Vec3> positions)
      : tree_(tree), spheres_(spheres), triangles_(triangles), positions_(positions) {}

  const SphereTree& tree() const { return tree_; }
  void refresh(std::uint32_t, std::uint32_t) const {}
  const Float4& sphere(std::uint32_t node) const { return spheres_[node]; }
  TriangleCorners corners(const Node& leaf) const {
    const Triangle& v = triangles_[tree_.triangle_of_leaf(leaf)];
    return {positions_[v[0]], positions_[v[1]], positions_[v[2]]};
  }

 private:
  const SphereTree& tree_;
  std::span<const Float4> spheres_;
  std::span<const Triangle> triangles_;
  std::span<const Vec3> positions_;
};

}  // namespace pelt::paper
