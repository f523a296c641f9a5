#pragma once

/// Two bodies, and operands near them for every kind of query.

#include "support/brute_force.hpp"
#include "support/skinned_shapes.hpp"

#include <pelt/crowd.hpp>
#include <pelt/motion.hpp>
#include <pelt/pelt.hpp>

#include <gtest/gtest.h>

#include <optional>
#include <span>
#include <vector>

namespace pelt::contract {

using test::Random;
using test::Shape;

using Triangles = std::vector<detail::TriangleCorners>;

/// The input that a program sets on a pose, or on an instance of a crowd.
struct PoseInput {
  std::vector<Matrix4> palette = {};
  std::vector<float> dual_quaternions = {};  ///< instead of the palette, unless empty
  std::vector<float> morph_weights = {};
  std::vector<Vec3> offsets = {};   ///< unless empty; poses borrow them
  std::vector<Vec3> vertices = {};  ///< instead of skinning, unless empty
};

/// Sets the input of a pose: `apply(input, pose)`; or of an instance: `apply(input, crowd, 3)`.
template <typename Target, typename... Instance>
void apply(const PoseInput& input, Target& target, Instance... instance) {
  if (input.dual_quaternions.empty()) {
    EXPECT_TRUE(target.set_palette(instance..., std::span<const Matrix4>(input.palette)));
  } else {
    EXPECT_TRUE(target.set_dual_quaternions(instance..., input.dual_quaternions));
  }
  if (!input.morph_weights.empty()) {
    EXPECT_TRUE(target.set_morph_weights(instance..., input.morph_weights));
  }
  if (!input.offsets.empty()) {
    EXPECT_TRUE(target.set_offsets(instance..., input.offsets));
  }
  if (!input.vertices.empty()) {
    EXPECT_TRUE(target.set_vertices(instance..., input.vertices));
  }
}

/// A body at both ends of a step.
struct Body {
  Body(Shape s, SkinnedModel m, PoseInput first, PoseInput last);

  /// Replaces both poses by new ones in the same places: nothing is opened or reserved.
  void renew();

  /// Reserves both poses, which forgets what queries have opened.
  void reserve();

  /// Sets the inputs of both poses again.
  void set();

  /// The same body, with its posed vertices as given vertices.
  Body given() const;

  pelt::Motion motion() { return {from, to}; }

  /// The triangles at the end of the step.
  Triangles triangles() const { return test::posed_triangles(shape.triangles, to); }

  Shape shape;
  PoseInput from_input, to_input;
  Pose from, to;
};

using test::positions_of;

struct Kind {
  const char* name;
  /// A body near `at`, with up to about 80 triangles times `size`. Kinds with places of their own
  /// ignore `at`.
  Body (*make)(Random& random, const Vec3& at, std::uint32_t size);
  /// Vertices are on planes and edges of other triangles, which only exact arithmetic decides.
  bool needs_exact_signs = false;
};

std::span<const Kind> kinds();

struct Stage {
  /// Bodies of one kind, or, in some cases, of two, up to `distance` apart on each axis if the kind
  /// can be placed.
  Stage(Random& random, const Kind& kind, double distance, std::uint32_t size = 1);

  /// The same stage, whose poses have the posed vertices as given vertices.
  Stage given() const;

  /// Forgets what queries have opened. `reserved`: allocates all memory of poses and scratch;
  /// otherwise, the next query allocates what it needs.
  void close(bool reserved);

  /// Exchanges the bodies. Other operands of queries of one body stay.
  void swap() { std::swap(a, b); }

  Body a, b;
  Scratch scratch;

  // Objects that a program makes once for its models. Queries of one body are asked of `a`.
  SelfFilter filter, filter_b;  ///< in some cases, these leave out pairs
  VertexGroups groups;

  // Operands within twice the size of `a`.
  Vec3 centre;
  float size = 1;
  double tolerance = 0;
  std::vector<Vec3> points, directions;
  std::vector<Ray> rays;
  Region region;
  Solid solid;
  HeightField field;

  // State of a query between calls.
  std::optional<CollisionSearch> search;
  std::optional<FirstContactSearch> first_contact_search;
  std::optional<SelfTracker> tracker;
  std::optional<Crowd> crowd;
  std::vector<Contact> described;
  std::uint32_t threads = 1;

 private:
  Stage(Body first, Body second, const Stage& operands);
};

}  // namespace pelt::contract
