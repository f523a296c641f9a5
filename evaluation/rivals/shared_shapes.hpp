#pragma once

#include <pelt/mesh.hpp>

#include <map>
#include <memory>
#include <span>

namespace pelt::rivals {

/// Data that is prepared once for all bodies of a mesh. Bodies with the same array of triangles
/// share it.
template <typename Shape>
class SharedShapes {
 public:
  explicit SharedShapes(std::uint32_t leaf_triangles) : leaf_triangles_(leaf_triangles) {}

  /// The largest number of triangles of a leaf.
  std::uint32_t leaf_triangles() const { return leaf_triangles_; }

  const Shape& of(std::span<const Triangle> triangles, std::span<const Vec3> rest) {
    std::unique_ptr<Shape>& shape = shapes_[triangles.data()];
    if (!shape) shape = std::make_unique<Shape>(triangles, rest, leaf_triangles_);
    return *shape;
  }

 private:
  std::uint32_t leaf_triangles_;
  std::map<const Triangle*, std::unique_ptr<Shape>> shapes_;
};

}  // namespace pelt::rivals
