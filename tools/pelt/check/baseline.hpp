#pragma once

/// Results of an earlier check, for `pelt check --baseline`.

#include "asset/json_object.hpp"
#include "tools/pelt/check/tallies.hpp"
#include "tools/pelt/check/touches.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pelt::tools::check {

class CheckBaseline {
 public:
  /// Two places, sorted because their order has no meaning, and the clip of their take.
  struct TouchNames {
    TouchName first, second;
    std::optional<std::string> clip = {};

    friend auto operator<=>(const TouchNames&, const TouchNames&) = default;
  };
  struct HeldNames {
    BodyName inner, outer;
    std::optional<std::string> clip = {};

    friend auto operator<=>(const HeldNames&, const HeldNames&) = default;
  };

  /// Parses the output of `pelt check --jsonl`; `path` is for messages. Returns an error for a
  /// check that cannot be compared with `question` (see question_json), for one that a limit cut
  /// short, and for a scene without a model in common with `scene`.
  static Result<CheckBaseline> parse(const std::string& path, std::string_view text,
                                     const nlohmann::ordered_json& question,
                                     const scenes::Scene& scene);

  static Result<CheckBaseline> read(const std::string& path, const nlohmann::ordered_json& question,
                                    const scenes::Scene& scene);

  /// The most contacts of one frame, or of one step between frames, of each touch.
  using Touches = std::map<TouchNames, std::uint64_t>;
  const Touches& touches() const { return touches_; }
  const Touches& touches_between() const { return touches_between_; }

  const std::set<HeldNames>& held() const { return held_; }

  /// Differences of that check from this one, in words; empty if only the files differ.
  std::span<const std::string> notes() const { return notes_; }

 private:
  static Result<CheckBaseline> compare(const nlohmann::json& first, const nlohmann::json& last,
                                       const nlohmann::ordered_json& question,
                                       const scenes::Scene& scene);
  static Touches read_touches(const asset::JsonObject& totals, const char* key);
  void take_held(const asset::JsonObject& totals);

  Touches touches_, touches_between_;
  std::set<HeldNames> held_;
  std::vector<std::string> notes_;
};

/// The most contacts of one frame or step; 0 if the places did not touch.
std::uint64_t worst_of(const CheckBaseline::Touches& touches,
                       const CheckBaseline::TouchNames& names);

/// Returns the names of a touch and of a contained body in a baseline.
CheckBaseline::TouchNames names_of(const scene::StagedScene& staged, const Touch& touch);
CheckBaseline::HeldNames names_of(const scene::StagedScene& staged, const Held& held);

}  // namespace pelt::tools::check
