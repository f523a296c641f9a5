#pragma once

/// Makes bodies from bytes: small meshes whose posed vertices have coordinates that are hard for
/// arithmetic.

#include "support/pinned_shapes.hpp"

#include <pelt/pose.hpp>
#include <pelt/surface.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace pelt::test {

/// Reads numbers from bytes; returns zeros after the last byte.
class FuzzBytes {
 public:
  explicit FuzzBytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  std::uint8_t next();
  bool is_empty() const { return next_ >= bytes_.size(); }

  /// A number below `count`.
  std::uint32_t index(std::uint32_t count) { return next() % count; }

  /// A number from a small grid or a list of special values, a fraction, or any float up to 2^58.
  float coordinate();
  Vec3 point();

  /// A nonnegative float.
  float size();

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t next_ = 0;
};

/// How the vertices of a body are posed.
enum class Posing : std::uint8_t {
  joints,
  offsets,  ///< joints, and offsets from the bytes
  given,    ///< `Pose::set_vertices`, with what joints would do
};

/// A posed mesh, with its vertices by the definition of skinning.
struct FuzzedBody {
  Shape shape;
  std::vector<Matrix4> palette;
  std::vector<float> morph_weights;
  Pose pose;
  std::vector<Vec3> posed;
  Posing posing = Posing::joints;
  std::vector<Vec3> offsets;  ///< the pose borrows them

  std::uint32_t triangle_count() const {
    return static_cast<std::uint32_t>(shape.triangles.size());
  }
  std::array<Vec3, 3> corners(std::size_t triangle) const {
    const auto [a, b, c] = shape.triangles[triangle];
    return {posed[a], posed[b], posed[c]};
  }

  /// The vertices of all triangles, posed.
  std::vector<std::array<Vec3, 3>> all_corners() const;

  /// Whether oracles that take microseconds per pair of triangles are quick enough.
  bool is_small() const { return shape.triangles.size() <= 20; }
};

/// Nullopt if Pelt refuses the mesh, the palette or the weights.
std::optional<FuzzedBody> make_body(FuzzBytes& bytes, Posing posing = Posing::joints);

/// Sets another palette. Leaves the body unchanged if Pelt refuses the palette.
void move_body(FuzzBytes& bytes, FuzzedBody& body);

/// A posed vertex, a point halfway between two of them, a point near a vertex, or any point.
Vec3 point_near(FuzzBytes& bytes, const FuzzedBody& body);

}  // namespace pelt::test
