#pragma once

/// The paper's method for one posed body: refits spheres and skins vertices when the descent needs
/// them, at most once per palette.

#include "paper/collide.hpp"
#include "paper/posed_triangles.hpp"
#include "paper/refit.hpp"

namespace pelt::paper {

/// The off-line part of section 4.2.
SphereModel build_sphere_model(const SkinnedMesh& mesh, BoundKind kind = BoundKind::optimised,
                               float collapse_ratio = kCollapseRatio);

class OnDemandBody {
 public:
  OnDemandBody(const SkinnedMesh& mesh, const SphereModel& model)
      : model_(model), refit_(model, mesh.joint_count), triangles_(model.leaf_mesh) {}

  /// Call after the palette has changed.
  void invalidate() {
    refit_.invalidate();
    triangles_.invalidate();
  }

  /// A body under a palette, as an operand of a descent.
  class Side {
   public:
    Side(OnDemandBody& body, const Palette& palette) : body_(body), palette_(palette) {}

    const SphereTree& tree() const { return body_.model_.tree; }
    void refresh(std::uint32_t first, std::uint32_t end) {
      for (std::uint32_t n = first; n < end; ++n)
        if (body_.refit_.is_stale(n)) {
          body_.triangles_.prefetch(tree().nodes[n]);
          body_.refit_.refit(n, palette_);
        }
    }
    /// Precondition: refreshed since the palette changed.
    const Float4& sphere(std::uint32_t node) const { return body_.refit_.spheres()[node]; }
    const TriangleCorners& corners(const Node& leaf) {
      return body_.triangles_.corners(leaf, palette_);
    }

   private:
    OnDemandBody& body_;
    const Palette& palette_;
  };

  /// Whether no descent has used the node's sphere since the palette changed.
  bool is_stale(std::uint32_t node) const { return refit_.is_stale(node); }

  std::uint64_t refits() const { return refit_.refits(); }
  std::uint64_t posed_vertices() const { return triangles_.posed_vertices(); }

 private:
  const SphereModel& model_;
  Refit refit_;
  PosedTriangles triangles_;
};

/// Appends the contacts of two bodies, in no particular order.
QueryStats collide(OnDemandBody& a, const Palette& palette_a, OnDemandBody& b,
                   const Palette& palette_b, Scratch& scratch, std::vector<Contact>& contacts,
                   std::uint32_t max_contacts);

}  // namespace pelt::paper
