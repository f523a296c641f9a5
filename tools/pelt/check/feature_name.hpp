#pragma once

#include <pelt/motion.hpp>

#include <cstddef>

namespace pelt::tools::check {

/// "corner", "edge" or "face".
inline const char* name_of(FeatureKind kind) {
  constexpr const char* kNames[] = {"corner", "edge", "face"};
  return kNames[static_cast<std::size_t>(kind)];
}

}  // namespace pelt::tools::check
