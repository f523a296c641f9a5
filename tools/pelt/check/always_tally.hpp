#pragma once

/// Counts the contacts that --self-always would drop, for a hint in the summary.

#include "tools/pelt/scene/scene_query.hpp"
#include "tools/pelt/scene/staged_scene.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace pelt::tools::check {

/// Numbers of contacts of characters with themselves.
struct AlwaysCounts {
  std::uint64_t contacts = 0;  ///< all of them
  std::uint64_t always = 0;    ///< those in at least a share of the poses
};

/// Counts contacts of characters with themselves whose triangles touch in at least a share of the
/// poses of their character: those of all its instances in all frames. Stores only the pairs of
/// triangles that can still reach the share.
class AlwaysTally {
 public:
  /// `frames`: number of frames that will be added. `staged` must outlive the tally.
  AlwaysTally(const scene::StagedScene& staged, std::size_t frames, double share);

  /// Adds the contacts of a frame. Cost: O(n log n) for n contacts of characters with themselves,
  /// and O(stored pairs).
  void add(const scene::FrameContacts& found);

  /// Precondition: all frames were added.
  AlwaysCounts counts() const;

 private:
  struct Count {
    Contact pair;
    std::size_t poses;
  };

  struct Character {
    std::size_t allowed_misses = 0, poses = 0;
    std::vector<Count> counts;  // ascending by pair
  };

  void add_pose(std::span<const Contact> contacts, Character& character);

  scene::StagedScene staged_;
  std::vector<Character> characters_;
  std::vector<std::vector<Contact>> found_;  // [instance] in the current frame
  std::vector<Count> merged_;
  std::uint64_t contacts_ = 0;
};

}  // namespace pelt::tools::check
