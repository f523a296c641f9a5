#pragma once

/// Content of a still picture: one frame, and its contacts.

#include "tools/pelt/scene/posed_instances.hpp"

#include <vector>

namespace pelt::tools::picture {

struct StillFrame {
  std::vector<scene::PosedInstance> instances;
  std::vector<std::vector<bool>> touching;  ///< by instance and triangle
};

/// `scene` must outlive the result.
Result<StillFrame> take_still(const scenes::Scene& scene, std::uint32_t frame);

}  // namespace pelt::tools::picture
