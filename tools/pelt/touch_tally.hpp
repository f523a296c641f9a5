#pragma once

/// Which parts and joints touch: contacts counted by the names that a person thinks in.

#include "tools/pelt/scene_query.hpp"

#include <map>
#include <string>
#include <vector>

namespace pelt::tools {

class TouchTally {
 public:
  /// Both arguments must outlive the tally.
  TouchTally(const scenes::Scene& scene, std::span<const Collider> colliders);

  void add(const FrameContacts& found);

  struct Row {
    std::string a, b;  ///< "knight 0 Hips"
    std::uint64_t contacts = 0;
  };

  /// The pairs with the most contacts, most first.
  std::vector<Row> joints(std::size_t most) const;
  std::vector<Row> parts(std::size_t most) const;

 private:
  /// A joint or part of an instance.
  struct Place {
    std::uint32_t instance = 0, index = 0;

    friend auto operator<=>(const Place&, const Place&) = default;
  };
  using Counts = std::map<std::pair<Place, Place>, std::uint64_t>;
  using Name = std::string (*)(const asset::Asset&, std::uint32_t index);

  /// For each triangle of a character: its joint (of the greatest weight, summed over the three
  /// vertices) and its part.
  struct Labels {
    std::vector<std::uint32_t> joint, part;
  };
  static Labels label_triangles(const asset::Asset& asset);

  const asset::Asset& asset_of(std::uint32_t instance) const;
  std::vector<Row> rows(const Counts& counts, std::size_t most, Name name) const;

  const scenes::Scene& scene_;
  std::span<const Collider> colliders_;
  std::vector<Labels> labels_;  // by character
  Counts joints_, parts_;
};

}  // namespace pelt::tools
