#pragma once

/// Sums over all frames of a check: totals, contacts that are nearly always there, contained
/// bodies, patches.

#include <pelt/self_filter.hpp>
#include <pelt/surface.hpp>

#include "tools/pelt/check/frame_answer.hpp"
#include "tools/pelt/check/steps.hpp"
#include "tools/pelt/scene/staged_scene.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace pelt::tools::check {

/// Totals of the frames of a take.
struct TakeTotals {
  std::uint32_t take = 0;  ///< index into Scene::takes
  std::uint64_t frames = 0, frames_in_contact = 0, contacts = 0;
  std::uint64_t worst = 0;        ///< the most contacts of one frame
  std::uint32_t worst_frame = 0;  ///< the first frame with as many
};

/// Pairs that --budget has left undecided.
struct UnknownTotals {
  std::vector<std::uint32_t> frames;  ///< frames with undecided pairs of bodies
  std::uint64_t most_pairs = 0;       ///< most undecided pairs of triangles in one frame
  double resolution = 0;              ///< longest side of all regions of missing contacts
};

struct CheckTotals {
  std::uint64_t frames = 0, frames_in_contact = 0, contacts = 0;
  std::uint64_t ignored = 0;             ///< contacts that do not count
  LeftOut left_out;                      ///< contacts of bodies with themselves that do not count
  QueryStats work;                       ///< without that of steps
  std::optional<BetweenReport> between;  ///< if steps were tested
  std::vector<TakeTotals> takes;         ///< of checked frames; empty if the scene has no takes
  UnknownTotals unknown;
  std::optional<std::uint64_t> hash;  ///< nullopt if contacts were limited
};

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

/// The longest patches of all frames, for each pair of joints. The length of an intersection does
/// not depend on the size of the triangles, unlike the depths of contacts.
class PatchTally {
 public:
  /// Both arguments must outlive the tally.
  explicit PatchTally(const scene::StagedScene& staged) : staged_(staged) {}

  /// Frames ascend.
  void add(std::uint32_t frame, std::span<const DescribedPatch> patches);

  std::uint64_t patches() const { return patches_; }

  /// Two joints, the length of their longest patch (see `ContactPatch::length`) and its frame.
  struct Row {
    std::string a, b;  ///< "knight 0 Hips"
    float length = 0;
    std::uint32_t frame = 0;
  };

  /// Rows for all pairs of joints, longest first.
  std::vector<Row> longest() const;

 private:
  struct Place {
    std::uint32_t collider = 0, joint = 0;

    friend auto operator<=>(const Place&, const Place&) = default;
  };
  struct Longest {
    float length = -1;
    std::uint32_t frame = 0;
  };

  std::string name(const Place& place) const;

  scene::StagedScene staged_;
  std::uint64_t patches_ = 0;
  std::map<std::pair<Place, Place>, Longest> longest_;
};

}  // namespace pelt::tools::check
