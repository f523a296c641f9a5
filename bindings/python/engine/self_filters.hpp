#pragma once

#include <pelt/self_filter.hpp>

#include "bindings/python/engine/clip_poses.hpp"

#include <string>

namespace pelt::python {

/// Throws an error that starts with `name` if a filter was made for another model, which would end
/// the program.
inline void check_model(const ClipPoses& poses, const SelfFilter& filter, const std::string& name) {
  if (&filter.model().detail() != &poses.model().detail())
    throw ArgumentError(name + ": the filter was made for another model");
}

}  // namespace pelt::python
