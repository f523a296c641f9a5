#pragma once

/// Inside tests of `pelt check --inside` for one frame.

#include <pelt/inside.hpp>

#include "scenes/ignored_pairs.hpp"
#include "tools/pelt/scene/near_pairs.hpp"
#include "tools/pelt/scene/scene_poses.hpp"
#include "tools/pelt/scene/scene_query.hpp"
#include "tools/pelt/scene/staged_scene.hpp"

#include <map>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

namespace pelt::tools::check {

/// Two colliders that penetrate each other, or one of which contains the other.
struct InsidePair {
  std::uint32_t a = 0, b = 0;
  Containment containment = Containment::none;
  Penetration a_in_b = {}, b_in_a = {};  ///< for closed surfaces; triangle numbers of the model
};

/// A collider that another one contains, in all frames or in those of a take.
struct Held {
  std::uint32_t inner = 0, outer = 0;
  std::uint32_t frames = 0, first_frame = 0;  ///< number of frames, and the first of them
  std::uint32_t take = 0;                     ///< index into the scene's takes, if it has any
};

/// Totals of all frames.
struct InsideTally {
  struct Deepest {
    double depth = 0;
    std::uint32_t inner = 0, outer = 0, frame = 0;
  };

  /// `take` is the index of the frame's take, or 0 without takes. Frames ascend.
  void add(std::uint32_t frame, std::span<const InsidePair> pairs, std::uint32_t take = 0);

  std::size_t closed_colliders = 0;        ///< number of colliders with an inside
  std::vector<std::uint32_t> frames_held;  ///< frames in which one collider contains another
  std::vector<Held> held;                  ///< in the order in which they were found
  Deepest deepest;  ///< among touching bodies; depth 0 if no vertex was inside

 private:
  void add_held(std::uint32_t inner, std::uint32_t outer, std::uint32_t frame);

  std::uint32_t take_ = 0;                                  // of the latest frame
  std::unordered_map<std::uint64_t, std::size_t> held_at_;  // [inner, outer] index into `held`
};

class InsideQuery {
 public:
  /// Skips pairs of colliders whose triangles are all matched by one rule of `ignored`. The objects
  /// that `staged` borrows, and `ignored`, must outlive this object.
  InsideQuery(const scene::StagedScene& staged, const scenes::IgnoredPairs& ignored);

  /// Replaces the results by those for these palettes. `found` has the contacts of the frame.
  /// Computes the depth of touching pairs, and whether one body of the other pairs contains the
  /// other. Touching pairs without a vertex inside are left out.
  Result<void> ask(const scene::Palettes& palettes, const scene::FrameContacts& found);

  std::span<const InsidePair> pairs() const { return pairs_; }  ///< ascending
  QueryStats work() const { return work_; }

 private:
  void ask_pair(std::uint32_t a, std::uint32_t b, bool touches);
  bool is_ignored(std::uint32_t a, std::uint32_t b);
  Penetration deepest(std::uint32_t a, std::uint32_t b);

  using Bodies = std::pair<scenes::IgnoredPairs::Body, scenes::IgnoredPairs::Body>;

  scene::StagedScene staged_;
  const scenes::IgnoredPairs& ignored_;
  std::map<Bodies, bool> are_ignored_;  // pairs that were looked up
  scene::NearPairs near_pairs_;
  scene::ScenePoses posed_;
  Scratch scratch_;
  QueryStats work_;
  std::vector<InsidePair> pairs_;
};

}  // namespace pelt::tools::check
