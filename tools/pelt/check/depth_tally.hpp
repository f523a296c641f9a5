#pragma once

/// Deepest contacts: patches of all frames, grouped by their joints.

#include <pelt/contact.hpp>

#include "tools/pelt/check/contact_details.hpp"
#include "tools/pelt/scene/staged_scene.hpp"

#include <map>
#include <string>
#include <vector>

namespace pelt::tools::check {

class DepthTally {
 public:
  /// Both arguments must outlive the tally.
  explicit DepthTally(const scene::StagedScene& staged) : staged_(staged) {}

  void add(std::uint32_t frame, const scene::FrameContacts& found, const ContactDetails& details);

  std::uint64_t patches() const { return patches_; }

  /// Two joints, their deepest patch and its frame.
  struct Row {
    std::string a, b;  ///< "knight 0 Hips"
    float depth = 0;
    std::uint32_t frame = 0;
  };

  /// Rows for all pairs of joints, deepest first.
  std::vector<Row> deepest() const;

 private:
  struct Place {
    std::uint32_t collider = 0, joint = 0;

    friend auto operator<=>(const Place&, const Place&) = default;
  };
  struct Deepest {
    float depth = -1;
    std::uint32_t frame = 0;
  };

  std::string name(const Place& place) const;

  scene::StagedScene staged_;
  std::uint64_t patches_ = 0;
  std::map<std::pair<Place, Place>, Deepest> deepest_;
};

}  // namespace pelt::tools::check
