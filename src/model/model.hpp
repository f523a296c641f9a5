#pragma once

#include <pelt/model.hpp>

#include "model/node_bounds.hpp"
#include "model/tree.hpp"

namespace pelt::detail {

/// What a SkinnedModel shares between its copies.
struct Model {
  Tree tree;
  NodeBounds bounds;
  BuildReport report;
};

}  // namespace pelt::detail
