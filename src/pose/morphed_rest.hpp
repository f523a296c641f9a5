#pragma once

#include "model/tree.hpp"

#include <span>
#include <vector>

namespace pelt::detail {

/// The rest positions of all vertices, as they lie in the tree, displaced by the active morph
/// targets. A copy where there are any, the tree's own where not.
class MorphedRest {
 public:
  MorphedRest(const Tree& tree, const MorphWeights& morphs);

  std::span<const Vec3> positions() const { return positions_; }

 private:
  std::vector<Vec3> morphed_;
  std::span<const Vec3> positions_;
};

}  // namespace pelt::detail
