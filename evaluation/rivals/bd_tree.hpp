#pragma once

/// A BD-tree for each of two bodies: the paper's sphere tree and descent
/// (paper/collide.hpp), but with spheres bounded by means and deviations instead of the
/// corners of the weights. Skins only the vertices of triangles that are tested.

#include "evaluation/rivals/bd_refit.hpp"
#include "paper/collide.hpp"
#include "paper/posed_triangles.hpp"

namespace pelt::rivals {

class BdBody {
 public:
  BdBody(const BdModel& model, std::uint32_t joint_count)
      : model_(model), refit_(model, joint_count), triangles_(model.leaf_mesh) {}

  /// Call after the palette has changed.
  void invalidate() {
    refit_.invalidate();
    triangles_.invalidate();
  }

  /// A body under a palette, as an operand of a descent.
  class Side {
   public:
    Side(BdBody& body, const Palette& palette) : body_(body), palette_(palette) {}

    const paper::SphereTree& tree() const { return body_.model_.tree; }
    void refresh(std::uint32_t first, std::uint32_t end) {
      for (std::uint32_t n = first; n < end; ++n)
        if (body_.refit_.is_stale(n)) body_.refit_.refit(n, palette_);
    }
    const Float4& sphere(std::uint32_t node) const { return body_.refit_.spheres()[node]; }
    const detail::TriangleCorners& corners(const paper::Node& leaf) {
      return body_.triangles_.corners(leaf, palette_);
    }

   private:
    BdBody& body_;
    const Palette& palette_;
  };

  std::uint64_t refits() const { return refit_.refits(); }
  std::uint64_t posed_vertices() const { return triangles_.posed_vertices(); }

 private:
  const BdModel& model_;
  BdRefit refit_;
  paper::PosedTriangles triangles_;
};

/// Appends the contacts of two bodies, in no particular order.
QueryStats collide(BdBody& a, const Palette& palette_a, BdBody& b, const Palette& palette_b,
                   paper::Scratch& scratch, std::vector<Contact>& contacts,
                   std::uint32_t max_contacts);

}  // namespace pelt::rivals
