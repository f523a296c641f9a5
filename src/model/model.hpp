#pragma once

#include "model/engine.hpp"
#include "model/skinned_mesh.hpp"

#include <memory>

namespace pelt::detail {

/// What a SkinnedModel shares between its copies.
struct Model {
  SkinnedMesh mesh;
  BuildReport report;
  std::shared_ptr<const Engine> engine;
};

}  // namespace pelt::detail
