#pragma once

/// Filters of the contacts of characters with themselves.

#include <pelt/self_filter.hpp>

#include "tools/pelt/arguments/values.hpp"
#include "tools/pelt/scene/staged_scene.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace pelt::tools::scene {

/// Contacts that do not count.
struct SelfRules {
  std::uint32_t rings = 5;        ///< see SelfFilterOptions::rings
  bool drops_at_rest = true;      ///< those of the rest pose and of the default pose of the nodes
  std::optional<double> always;   ///< those of at least this share of the poses of a character
  bool drops_near_joints = true;  ///< see near_joints
};

struct SelfFilters {
  std::vector<SelfFilter> of_colliders;  ///< of each collider with itself

  /// One filter per instance, for contacts between its parts. Triangles are numbered as in the
  /// whole character. Empty if colliders are whole instances.
  std::vector<SelfFilter> of_parts;
};

/// Returns the filters of a scene. Instances of one character share them.
///
/// With `rules.always`, first finds the contacts of all `frames`, which takes as long as the check
/// itself. Error messages name the file or the frame.
Result<SelfFilters> make_self_filters(const StagedScene& staged, const SelfRules& rules,
                                      const arguments::FrameRange& frames);

}  // namespace pelt::tools::scene
