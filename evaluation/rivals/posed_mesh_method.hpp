#pragma once

/// The face of methods that start from posed vertices and know nothing of joints: most of what
/// people use for animated characters. Whoever measures one skins all vertices first, and counts
/// that as part of its cost.

#include <pelt/collide.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace pelt::rivals {

/// Bodies are numbered in the order of `add`.
class PosedMeshMethod {
 public:
  virtual ~PosedMeshMethod() = default;

  /// Adds a body at its rest positions. `triangles` outlives this, `rest` is read during the call.
  virtual void add(std::span<const Triangle> triangles, std::span<const Vec3> rest) = 0;

  /// The vertices of a body have moved, or are told for the first time, which comes before any
  /// question about it. `positions` stays as it is until the next update of the body.
  virtual void update(std::uint32_t body, std::span<const Vec3> positions) = 0;

  /// Appends the contacts of two bodies in no particular order, until all are found or
  /// `max_contacts` of them; returns the work, skinning and updates apart.
  virtual QueryStats collide(std::uint32_t a, std::uint32_t b, std::vector<Contact>& contacts,
                             std::uint32_t max_contacts) = 0;
};

}  // namespace pelt::rivals
