#pragma once

/// Numbers the places of a scene where contacts are counted.

#include "tools/pelt/scene/staged_scene.hpp"

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

namespace pelt::tools::check {

/// A place on an instance: a part, and a joint that triangles of the part follow.
struct TouchPlace {
  std::uint32_t instance = 0, part = 0, joint = 0;

  friend auto operator<=>(const TouchPlace&, const TouchPlace&) = default;
};

/// All places of a scene, ascending. Parts with equal names count as one, the first of them, and so
/// do joints, because names cannot distinguish them.
class TouchPlaces {
 public:
  /// Returns an error if no model can be built from the assets.
  static Result<TouchPlaces> make(const scene::StagedScene& staged);

  /// The places of an instance's triangles, numbered as in its asset.
  struct InstancePlaces {
    std::uint32_t first = 0;                  ///< number of the instance's first place
    std::span<const std::uint32_t> place_of;  ///< [T] number of a triangle's place, less `first`

    std::uint32_t number_at(std::uint32_t triangle) const { return first + place_of[triangle]; }
  };

  InstancePlaces of_instance(std::uint32_t instance) const {
    const CharacterPlaces& character = characters_[character_of_[instance]];
    return {first_of_[instance], character.place_of};
  }

  const TouchPlace& operator[](std::uint32_t number) const { return places_[number]; }

 private:
  struct CharacterPlaces {
    std::vector<std::uint32_t> place_of;  ///< [T] index into `places`
    std::vector<TouchPlace> places;       ///< ascending, of instance 0
  };

  static CharacterPlaces number_places(std::span<const std::uint32_t> parts,
                                       std::span<const std::uint16_t> joints);

  std::vector<CharacterPlaces> characters_;
  std::vector<std::uint32_t> character_of_, first_of_;  // by instance
  std::vector<TouchPlace> places_;
};

}  // namespace pelt::tools::check
