#pragma once

/// Which frames of a scene a benchmark measures.

#include <pelt/result.hpp>

#include "scenes/scene.hpp"
#include "tools/pelt/arguments/values.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pelt::tools::bench {

/// The chosen frames, or all if nullopt. Returns an error if the scene has fewer frames.
Result<std::vector<std::uint32_t>> choose_frames(
    const scenes::Scene& scene, const std::optional<arguments::FrameRange>& chosen);

/// Returns an error if there is no pair of instances. `alternative` ends its message.
Result<void> require_two_instances(const scenes::Scene& scene, const std::string& alternative = "");

}  // namespace pelt::tools::bench
