#pragma once

/// Names of bodies and places in answers, chosen so that the next version of a scene has the same
/// names. Uses numbers only for instances of one model, which differ only in their order.

#include "tools/pelt/check/inside_query.hpp"
#include "tools/pelt/check/touch_tally.hpp"
#include "tools/pelt/scene/staged_scene.hpp"

#include <nlohmann/json_fwd.hpp>

#include <compare>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace pelt::tools::check {

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

/// Returns a touch as `pelt check --jsonl` writes it. `instance` is the number in the scene. The
/// object has the member `clip` if the scene has takes.
nlohmann::ordered_json touch_json(const scene::StagedScene& staged, const Touch& touch);

/// Returns a contained body and its container, in the same form.
nlohmann::ordered_json held_json(const scene::StagedScene& staged, const Held& held);

/// An object with `clip`, or an empty one without a clip.
nlohmann::ordered_json of_clip(const std::optional<std::string>& clip);

/// Without numbers of instances, for places that are no longer in the scene.
nlohmann::ordered_json name_json(const BodyName& name);
nlohmann::ordered_json name_json(const TouchName& name);

}  // namespace pelt::tools::check
