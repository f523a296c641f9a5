#pragma once

/// The method that section 5 of the paper compares with: rigid body detection with a new sphere
/// tree over the posed mesh. Its query is a lower bound; its build is counted separately.

#include "paper/posed_side.hpp"
#include "paper/scratch.hpp"
#include "skin/palette.hpp"

#include <pelt/collide.hpp>

#include <vector>

namespace pelt::paper {

using detail::Palette;

class RigidBody {
 public:
  explicit RigidBody(const SkinnedMesh& mesh) : mesh_(mesh), positions_(mesh.vertex_count()) {}

  /// Skins all vertices and builds the tree; returns the counts.
  QueryStats update(const Palette& palette);

  PosedSide side() const { return {tree_, spheres_, mesh_.triangles, positions_}; }

 private:
  const SkinnedMesh& mesh_;
  std::vector<Vec3> positions_;
  SphereTree tree_;
  std::vector<Float4> spheres_;
};

/// Appends the contacts of two bodies, in no particular order.
QueryStats collide(const RigidBody& a, const RigidBody& b, Scratch& scratch,
                   std::vector<Contact>& contacts, std::uint32_t max_contacts);

}  // namespace pelt::paper
