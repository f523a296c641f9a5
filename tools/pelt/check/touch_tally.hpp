#pragma once

/// Counts contacts by named places.

#include "scenes/triangle_labels.hpp"
#include "tools/pelt/scene/scene_query.hpp"
#include "tools/pelt/scene/staged_scene.hpp"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace pelt::tools::check {

/// A place on an instance: a part, and a joint that triangles of the part follow.
struct TouchPlace {
  std::uint32_t instance = 0, part = 0, joint = 0;

  friend auto operator<=>(const TouchPlace&, const TouchPlace&) = default;
};

/// Contacts over all frames, or over those of a take.
struct TouchCounts {
  std::uint64_t contacts = 0;
  std::uint32_t frames = 0;       ///< with contacts
  std::uint64_t worst = 0;        ///< the most contacts of one frame
  std::uint32_t worst_frame = 0;  ///< the first frame with as many

  /// Adds the contacts of a frame, at least one. Frames ascend.
  void add(std::uint32_t frame, std::uint64_t found);
};

/// The contacts of two places.
struct Touch : TouchCounts {
  TouchPlace a, b;         ///< a <= b
  std::uint32_t take = 0;  ///< index into the scene's takes, if it has any
};

/// Counts contacts by places. Parts with equal names count as one, the first of them, and so do
/// joints, because names cannot distinguish them.
class TouchTally {
 public:
  /// Both arguments must outlive the tally. Returns an error if no model can be built from the
  /// assets.
  static Result<TouchTally> make(const scene::StagedScene& staged);

  /// Adds the contacts of a frame. Call once per frame.
  void add(std::uint32_t frame, const scene::FrameContacts& found);

  /// Sorted by number of contacts, descending.
  std::vector<Touch> touches() const;

  struct Row : TouchCounts {
    std::string clip;  ///< in quotes; "" if the scene has no takes
    std::string a, b;  ///< "knight 0 Hips"
  };

  /// The pairs with the most contacts first.
  std::vector<Row> joints() const;
  std::vector<Row> parts() const;

 private:
  using PlacePair = std::pair<TouchPlace, TouchPlace>;  // ascending
  using Key = std::pair<std::uint32_t, PlacePair>;      // take, places
  using FrameCounts = std::map<PlacePair, std::uint64_t>;
  using NameOf = std::function<std::string(std::uint32_t character, std::uint32_t index)>;

  explicit TouchTally(const scene::StagedScene& staged) : staged_(staged) {}

  /// The places of an instance's triangles.
  struct Places {
    std::uint32_t instance = 0;
    const scenes::TriangleLabels& labels;

    TouchPlace at(std::uint32_t triangle) const {
      return {instance, labels.part[triangle], labels.joint[triangle]};
    }
  };

  Places places_of(std::uint32_t collider) const;
  void count_pair(const scene::FrameContacts& found, const scene::FrameContacts::Pair& pair,
                  FrameCounts& touches) const;
  std::vector<Row> rows(const std::map<Key, TouchCounts>& counts, std::uint32_t TouchPlace::*index,
                        const NameOf& name_of) const;

  scene::StagedScene staged_;
  std::vector<scenes::TriangleLabels> labels_;  // by character
  std::map<Key, TouchCounts> touches_;
  std::map<Key, TouchCounts> joints_, parts_;  // places with the other index 0
};

}  // namespace pelt::tools::check
