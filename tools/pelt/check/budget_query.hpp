#pragma once

/// Finds contacts of one frame of a scene with a limit of the work. `pelt check --budget` uses it
/// instead of a SceneQuery.

#include <pelt/search.hpp>

#include "tools/pelt/scene/near_pairs.hpp"
#include "tools/pelt/scene/scene_poses.hpp"
#include "tools/pelt/scene/scene_query.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace pelt::tools::check {

/// Two colliders whose contacts are not all known.
struct Undecided {
  std::uint32_t a = 0, b = 0;
  pelt::Verdict verdict = pelt::Verdict::unknown;  ///< or touching
  std::uint64_t pairs = 0;                         ///< undecided pairs of triangles
  double resolution = 0;      ///< longest side of the regions of missing contacts
  double distance_bound = 0;  ///< upper bound of the distance
};

class BudgetQuery {
 public:
  /// `budget`: units of work for each pair of colliders in each frame. `colliders` must outlive the
  /// query.
  BudgetQuery(std::span<const scene::Collider> colliders, std::uint64_t budget)
      : colliders_(colliders), posed_(colliders), budget_(budget) {}

  /// Error messages name the instance.
  Result<void> set_palettes(const scene::Palettes& palettes) {
    return posed_.set_palettes(palettes);
  }

  /// Replaces `found` by the contacts that the budget suffices for.
  void collide(const Limits& limits, scene::FrameContacts& found);

  /// Pairs of the last frame whose contacts are not all in its answer, ascending.
  std::span<const Undecided> undecided() const { return undecided_; }

  /// The work so far.
  QueryStats work() const { return work_; }

 private:
  std::span<const scene::Collider> colliders_;
  scene::ScenePoses posed_;
  std::uint64_t budget_;
  scene::NearPairs near_pairs_;
  Scratch scratch_;
  std::vector<Undecided> undecided_;
  std::vector<Contact> contacts_;
  QueryStats work_;
};

}  // namespace pelt::tools::check
