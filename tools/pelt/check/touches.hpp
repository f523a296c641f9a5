#pragma once

/// Counts contacts by named places of a scene: by parts, and by joints that their triangles follow.

#include "tools/pelt/scene/frame_contacts.hpp"
#include "tools/pelt/scene/staged_scene.hpp"

#include <compare>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
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

/// Contacts over all frames, or over those of a take.
struct TouchCounts {
  std::uint64_t contacts = 0;
  std::uint32_t frames = 0;       ///< with contacts
  std::uint64_t worst = 0;        ///< the most contacts of one frame
  std::uint32_t worst_frame = 0;  ///< the first frame with `worst` contacts

  /// Adds the contacts of a frame, at least one. Frames ascend.
  void add(std::uint32_t frame, std::uint64_t found);
};

/// The contacts of two places.
struct Touch : TouchCounts {
  TouchPlace a, b;         ///< a <= b
  std::uint32_t take = 0;  ///< index into the scene's takes, if it has any
};

/// Touches, with the contacts of the current frame.
class FrameTouches {
 public:
  /// Adds a touch without contacts. Returns its index.
  std::uint32_t add(std::uint32_t take, const TouchPlace& a, const TouchPlace& b);

  /// Adds contacts, at least one, to a touch in the current frame.
  void count(std::uint32_t touch, std::uint64_t contacts) {
    if (in_frame_[touch] == 0) counted_.push_back(touch);
    in_frame_[touch] += contacts;
  }

  /// The touches with contacts in the current frame, and the number of them.
  std::span<const std::uint32_t> counted() const { return counted_; }
  std::uint64_t in_frame(std::uint32_t touch) const { return in_frame_[touch]; }

  /// Adds the contacts of the current frame to the sums, and starts the next frame.
  void end_frame(std::uint32_t frame);

  /// Returns the touches by contacts, descending, then by take and places.
  std::vector<Touch> sorted() const;

 private:
  std::vector<Touch> touches_;
  std::vector<std::uint64_t> in_frame_;  // by touch
  std::vector<std::uint32_t> counted_;
};

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

/// An instance, or a part of one. Texts are as stored in JSON, which must be UTF-8.
struct BodyName {
  std::string model;
  std::uint32_t copy = 0;  ///< index among the instances of this model name
  std::string part;        ///< "" for a whole instance

  friend auto operator<=>(const BodyName&, const BodyName&) = default;
};

struct TouchName {
  BodyName body;  ///< includes the part
  std::string joint;

  friend auto operator<=>(const TouchName&, const TouchName&) = default;
};

/// The clip of a take, as stored in JSON; nullopt if the scene has no takes.
std::optional<std::string> clip_name(const scenes::Scene& scene, std::uint32_t take);

BodyName body_name(const scene::StagedScene& staged, const scene::Collider& collider);
TouchName touch_name(const scene::StagedScene& staged, const TouchPlace& place);

/// "knight 0", with the number of the instance in the scene; printable.
std::string instance_words(const scene::StagedScene& staged, std::uint32_t instance);

/// Whether a touch of two instances is one of an instance with itself, and not of two of its parts.
bool is_of_itself(const scene::StagedScene& staged, std::uint32_t a, std::uint32_t b);

/// Replaces the name of the instance at the second place of a touch of an instance with itself.
inline const std::string kItself = "itself ";

/// "knight 0 Cape Spine", with the number of the instance in the scene; printable.
std::string in_words(const scene::StagedScene& staged, const TouchPlace& place);

/// Both places: "knight 0 Hand  itself Cape" if they are of one instance.
std::string touch_words(const scene::StagedScene& staged, const Touch& touch);

}  // namespace pelt::tools::check
