#pragma once

/// Counts contacts by named places.

#include "tools/pelt/check/touch_counts.hpp"
#include "tools/pelt/check/touch_places.hpp"
#include "tools/pelt/scene/scene_query.hpp"
#include "tools/pelt/scene/staged_scene.hpp"

#include <functional>
#include <map>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace pelt::tools::check {

/// Counts contacts by pairs of places, of joints and of parts.
class TouchTally {
 public:
  /// The scene and the colliders of `staged` must outlive the tally. Returns an error if no model
  /// can be built from the assets.
  static Result<TouchTally> make(const scene::StagedScene& staged);

  /// Adds the contacts of a frame. Call once per frame, in the order of frames.
  void add(std::uint32_t frame, const scene::FrameContacts& found);

  /// Sorted by number of contacts, descending.
  std::vector<Touch> touches() const { return touches_.sorted(); }

  struct Row : TouchCounts {
    std::string clip;  ///< in quotes; "" if the scene has no takes
    std::string a, b;  ///< "knight 0 Hips"
  };

  /// The pairs with the most contacts first.
  std::vector<Row> joints() const;
  std::vector<Row> parts() const;

 private:
  using NameOf = std::function<std::string(std::uint32_t character, std::uint32_t index)>;

  /// Touches of joints or of parts: the other index of their places is 0.
  struct CoarseTouches {
    FrameTouches touches;
    std::map<std::pair<TouchPlace, TouchPlace>, std::uint32_t> in_take;  // those of this take

    std::uint32_t find_or_add(std::uint32_t take, const TouchPlace& a, const TouchPlace& b);
  };

  /// The touches of joints and of parts that a touch belongs to.
  struct CoarseIndices {
    std::uint32_t joints = 0, parts = 0;
  };

  TouchTally(const scene::StagedScene& staged, TouchPlaces places)
      : staged_(staged), places_(std::move(places)) {}

  void start_take(std::uint32_t take);
  void count_pair(const scene::FrameContacts& found, const scene::FrameContacts::Pair& pair);
  void count(std::uint32_t place, std::uint32_t other, std::uint64_t contacts);
  std::uint32_t add_touch(const TouchPlace& a, const TouchPlace& b);
  std::vector<Row> rows(const FrameTouches& touches, std::uint32_t TouchPlace::*index,
                        const NameOf& name_of) const;

  scene::StagedScene staged_;
  TouchPlaces places_;
  std::uint32_t take_ = 0;
  std::unordered_map<std::uint64_t, std::uint32_t> in_take_;  // by the numbers of two places
  FrameTouches touches_;
  std::vector<CoarseIndices> coarse_;  // by touch
  CoarseTouches joints_, parts_;
};

}  // namespace pelt::tools::check
