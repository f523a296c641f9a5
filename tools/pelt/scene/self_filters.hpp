#pragma once

/// Filters of the contacts of characters with themselves.

#include <pelt/crowd.hpp>
#include <pelt/self_filter.hpp>

#include "tools/pelt/arguments/values.hpp"
#include "tools/pelt/scene/frame_contacts.hpp"
#include "tools/pelt/scene/staged_scene.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <span>
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

  /// The filter of each instance for contacts between its parts. Triangles are numbered as in the
  /// whole character. Empty if colliders are whole instances.
  std::map<std::uint32_t, SelfFilter> of_parts;

  /// Whether the filters may drop any contacts of pairs, so that a query needs all of them.
  bool need_all_of_pairs() const { return !of_parts.empty(); }

  /// Removes from `found` the contacts of two parts of one instance that its filter drops, and
  /// those beyond the limit of each pair. Returns the number of dropped contacts.
  LeftOut leave_out_between_parts(std::span<const Collider> colliders, const Limits& limits,
                                  Scratch& scratch, FrameContacts& found) const;
};

/// Selects the colliders to test against each other and against themselves.
struct SelfTests {
  bool pairs = true;                   ///< colliders against each other
  std::optional<SelfFilters> filters;  ///< if set, also each collider against itself

  /// The tests as those of a crowd of the colliders, valid as long as this.
  CrowdOptions crowd_options() const;
};

/// Returns the filters of a scene. Instances of one character share them.
///
/// With `rules.always`, first finds the contacts of all `frames`, which takes as long as the check
/// itself. Error messages name the file or the frame.
Result<SelfFilters> make_self_filters(const StagedScene& staged, const SelfRules& rules,
                                      const arguments::FrameRange& frames);

}  // namespace pelt::tools::scene
