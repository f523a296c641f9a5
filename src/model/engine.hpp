#pragma once

/// What the public functions need of the structure that answers queries, and all that they know of
/// it. Implemented by one file of src/query.

#include <pelt/collide.hpp>

#include "model/skinned_mesh.hpp"

#include <memory>

namespace pelt::detail {

class Palette;

/// What is prepared once for a mesh.
struct Engine;

/// One pose's bounds, as far as queries have asked for them.
struct EnginePose;

std::shared_ptr<const Engine> build_engine(const SkinnedMesh& mesh);

using EnginePoseHandle = std::unique_ptr<EnginePose, void (*)(EnginePose*)>;
EnginePoseHandle make_engine_pose(const Engine& engine);

/// The palette has changed: all bounds are stale.
void invalidate(EnginePose& pose);

/// What a query knows of one side.
struct EngineSide {
  const SkinnedMesh& mesh;
  const Palette& palette;
  const Engine& engine;
  EnginePose& pose;
};

/// Appends at most `max_contacts` contacts in no particular order.
QueryStats engine_collide(const EngineSide& a, const EngineSide& b, Scratch& scratch,
                          std::vector<Contact>& contacts, std::uint32_t max_contacts);

}  // namespace pelt::detail
