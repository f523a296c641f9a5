#pragma once

/// Contacts that do not count: those of parts and joints that a scene or `--ignore` names.

#include "tools/pelt/scene_query.hpp"
#include "tools/pelt/triangle_labels.hpp"

#include <span>
#include <string_view>
#include <vector>

namespace pelt::tools {

class IgnoredPairs {
 public:
  /// Refuses a name that no part and no joint of the scene has. `scene` and `colliders` must
  /// outlive this. O(names times parts and joints, plus triangles).
  static Result<IgnoredPairs> make(const scenes::Scene& scene, std::span<const Collider> colliders,
                                   std::span<const scenes::NamePair> pairs);

  /// Takes the contacts out that do not count, and pairs of colliders that have no others; returns
  /// how many contacts that were.
  std::uint64_t take_out(FrameContacts& found) const;

 private:
  /// [character][triangle] whether one name of a pair means it.
  using Meant = std::vector<std::vector<bool>>;

  IgnoredPairs(const scenes::Scene& scene, std::span<const Collider> colliders)
      : scene_(&scene), colliders_(colliders) {}

  bool add(std::string_view name, std::span<const TriangleLabels> labels);
  bool is_ignored(std::uint32_t character_a, std::uint32_t character_b,
                  const Contact& contact) const;

  const scenes::Scene* scene_;
  std::span<const Collider> colliders_;
  std::vector<Meant> meant_;  // two of each pair
};

}  // namespace pelt::tools
