#pragma once

/// The longest patches of all frames, for each pair of joints. The length of an intersection does
/// not depend on the size of the triangles, unlike the depths of contacts.

#include <pelt/surface.hpp>

#include "tools/pelt/check/contact_details.hpp"
#include "tools/pelt/scene/staged_scene.hpp"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace pelt::tools::check {

/// A patch, without its contacts.
struct DescribedPatch {
  std::uint32_t a = 0, b = 0;              ///< colliders
  std::uint32_t joint_a = 0, joint_b = 0;  ///< as in the assets
  float length = 0;                        ///< see `ContactPatch::length`
};

/// Returns all patches of a frame. `details` describes `found`.
std::vector<DescribedPatch> described_patches(const scene::FrameContacts& found,
                                              const ContactDetails& details);

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
