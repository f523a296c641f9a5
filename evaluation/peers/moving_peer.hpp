#pragma once

/// Continuous collision detection of other libraries, with the interface of methods that start from
/// posed vertices. Linear motion between two meshes, as in Pelt.

#include <pelt/collide.hpp>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace pelt::peers {

/// Two triangles, and the time from 0 to 1 at which they first touch.
struct TimedPair {
  Contact contact;
  double time = 0;
};

class MovingMeshMethod {
 public:
  virtual ~MovingMeshMethod() = default;

  virtual void add(std::span<const Triangle> triangles, std::span<const Vec3> rest) = 0;

  /// Begins a step of a body that ends with these positions. It starts where the step before ended.
  virtual void update(std::uint32_t body, std::span<const Vec3> positions) = 0;

  /// Appends the pairs of triangles that touch during the step, in any order.
  virtual void collide_moving(std::uint32_t a, std::uint32_t b, std::uint32_t max_pairs,
                              std::vector<TimedPair>& pairs) = 0;
};

/// `scale`: the number by which all positions are multiplied; see fcl_moving.cpp.
std::unique_ptr<MovingMeshMethod> make_fcl_moving(double scale);

}  // namespace pelt::peers
