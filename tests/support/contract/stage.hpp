#pragma once

/// Two bodies, and operands near them for every kind of query.

#include "support/contract/bodies.hpp"

#include <pelt/crowd.hpp>
#include <pelt/pelt.hpp>

#include <optional>
#include <vector>

namespace pelt::contract {

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

  // What a program makes once for its models. Queries of one body are asked of `a`.
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

  // What a query keeps from call to call.
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
