#pragma once

/// The method that the paper compares with (van den Bergen 1997; "bottom-up" in its section 5):
/// after every change, skins all vertices and refits all spheres of the same tree, leaves first.

#include "paper/posed_side.hpp"
#include "paper/scratch.hpp"
#include "skin/palette.hpp"

#include <pelt/collide.hpp>

#include <vector>

namespace pelt::paper {

using detail::Palette;

class EagerBody {
 public:
  EagerBody(const SkinnedMesh& mesh, const SphereTree& tree);

  /// Skins all vertices and refits all spheres. Returns the counts of both.
  QueryStats update(const Palette& palette);

  /// The two halves of update(), which can be timed separately.
  void skin(const Palette& palette);
  void refit_bottom_up();

  PosedSide side() const { return {tree_, spheres_, mesh_.triangles, positions_}; }
  std::span<const Float4> spheres() const { return spheres_; }

 private:
  struct Leaf {
    std::uint32_t node;
    Triangle corners;
  };

  void refit_leaves();
  std::span<Vec3> positions() { return {positions_.data(), mesh_.vertex_count()}; }

  const SkinnedMesh& mesh_;
  const SphereTree& tree_;
  std::vector<Leaf> leaves_;
  std::vector<std::uint32_t> inner_nodes_;
  std::vector<Vec3> positions_;  // [V + 1], so that four floats can be loaded from each
  std::vector<Float4> spheres_;
};

/// Appends the contacts of two bodies, in no particular order.
QueryStats collide(const EagerBody& a, const EagerBody& b, Scratch& scratch,
                   std::vector<Contact>& contacts, std::uint32_t max_contacts);

}  // namespace pelt::paper
