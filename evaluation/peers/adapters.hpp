#pragma once

/// The methods of other libraries, with the interface of methods that start from posed vertices.
/// Each adapter's file provides the methods and the version of its library.

#include <pelt/collide.hpp>

#include "evaluation/rivals/posed_mesh_method.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace pelt::peers {

/// A method whose bodies do not depend on each other.
template <typename Body>
class MethodOfBodies : public rivals::PosedMeshMethod {
 public:
  void add(std::span<const Triangle> triangles, std::span<const Vec3> rest) final {
    bodies_.push_back(std::make_unique<Body>(triangles, rest));
  }

  void update(std::uint32_t body, std::span<const Vec3> positions) final {
    bodies_[body]->update(positions);
  }

 protected:
  std::vector<std::unique_ptr<Body>> bodies_;
};

std::unique_ptr<rivals::PosedMeshMethod> make_fcl();
std::string fcl_version();

std::unique_ptr<rivals::PosedMeshMethod> make_embree();
std::string embree_version();

/// With Pelt's predicate, and with Bullet's triangle test.
std::unique_ptr<rivals::PosedMeshMethod> make_bullet();
std::unique_ptr<rivals::PosedMeshMethod> make_bullet_own();
std::string bullet_version();

std::unique_ptr<rivals::PosedMeshMethod> make_ode();
std::string ode_version();

std::unique_ptr<rivals::PosedMeshMethod> make_cgal_tree();
std::unique_ptr<rivals::PosedMeshMethod> make_cgal_boxes();
std::string cgal_version();

// Methods for a body against itself: `collide` is called with one body twice, and finds each pair
// of triangles once, with the lower number first.

std::unique_ptr<rivals::PosedMeshMethod> make_self_cgal_mesh();

/// With Pelt's predicates; the same without pairs of neighbours; and with CGAL's predicate, without
/// pairs of neighbours.
std::unique_ptr<rivals::PosedMeshMethod> make_self_cgal_boxes();
std::unique_ptr<rivals::PosedMeshMethod> make_self_cgal_boxes_apart();
std::unique_ptr<rivals::PosedMeshMethod> make_self_cgal_boxes_own();

std::unique_ptr<rivals::PosedMeshMethod> make_self_embree();

/// Two triangles, and the time from 0 to 1 at which they first touch.
struct TimedPair {
  Contact contact;
  double time = 0;
};

/// Continuous collision detection: linear motion between two meshes, as in Pelt.
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

/// `scale`: the number by which all positions are multiplied; see fcl.cpp.
std::unique_ptr<MovingMeshMethod> make_fcl_moving(double scale);

}  // namespace pelt::peers
