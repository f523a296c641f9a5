#pragma once

#include <pelt/result.hpp>

#include "tools/pelt/scene/colliders.hpp"

#include <cstdint>
#include <span>

namespace pelt::tools::bench {

/// Self filters of the models of a scene, each counted once.
struct SelfFilterFigures {
  std::uint64_t bytes = 0;
  double build_seconds = 0;
};

/// Builds the filters that the method self uses: those of `build_self_filter` without options.
Result<SelfFilterFigures> measure_self_filters(std::span<const scene::Collider> colliders);

}  // namespace pelt::tools::bench
