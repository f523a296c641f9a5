#pragma once

#include "tools/pelt/touch_tally.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace pelt::tools {

/// A place of a touch by names, which the next version of a scene has too.
struct TouchName {
  std::uint32_t instance = 0;
  std::string model, part, joint;

  friend auto operator<=>(const TouchName&, const TouchName&) = default;
};

TouchName touch_name(const scenes::Scene& scene, const TouchPlace& place);

/// "knight 0 Cape Spine"
std::string in_words(const TouchName& name);

/// As `pelt check --jsonl` has it.
nlohmann::ordered_json touch_json(const scenes::Scene& scene, const Touch& touch);

}  // namespace pelt::tools
