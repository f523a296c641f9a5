#pragma once

/// Makes bodies from bytes: small meshes whose posed vertices and queries have coordinates that are
/// hard for arithmetic.

#include "support/pinned_shapes.hpp"

#include <pelt/contact.hpp>
#include <pelt/pose.hpp>

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

/// A posed mesh, with its vertices by the definition of skinning.
struct FuzzedBody {
  Shape shape;
  std::vector<Matrix4> palette;
  std::vector<float> morph_weights;
  Pose pose;
  Surface surface;
  std::vector<Vec3> posed;

  std::array<Vec3, 3> corners(std::size_t triangle) const {
    const auto [a, b, c] = shape.triangles[triangle];
    return {posed[a], posed[b], posed[c]};
  }
};

/// Nullopt if Pelt refuses the mesh, the palette or the weights.
std::optional<FuzzedBody> make_body(FuzzBytes& bytes);

}  // namespace pelt::test
