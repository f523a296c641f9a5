#pragma once

/// The interface of methods that start from posed vertices and do not use joints, like most
/// libraries that people use for animated characters. Measuring such a method includes skinning all
/// vertices first.

#include <pelt/collide.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace pelt::rivals {

/// Bodies are numbered in the order of `add`.
class PosedMeshMethod {
 public:
  virtual ~PosedMeshMethod() = default;

  /// Adds a body at its rest positions. `triangles` must outlive this object; `rest` is read during
  /// the call only.
  virtual void add(std::span<const Triangle> triangles, std::span<const Vec3> rest) = 0;

  /// Sets the posed vertices of a body. The first call must precede any query of the body.
  /// `positions` must stay unchanged until the next update of the body.
  virtual void update(std::uint32_t body, std::span<const Vec3> positions) = 0;

  /// Appends all contacts of two bodies, or `max_contacts` of them, in no particular order. Returns
  /// the work without skinning and updates.
  virtual QueryStats collide(std::uint32_t a, std::uint32_t b, std::vector<Contact>& contacts,
                             std::uint32_t max_contacts) = 0;
};

}  // namespace pelt::rivals
