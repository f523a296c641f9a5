#pragma once

#include <pelt/distance.hpp>

#include "bindings/wasm/engine/handles.hpp"

#include <initializer_list>

namespace pelt::wasm {

struct PointOfPose {
  const SurfacePoint& point;
  const PoseHandle& pose;
};

/// The answer is these, seven numbers each: triangle, position, weights of its corners.
void answer_points(std::initializer_list<PointOfPose> points);

}  // namespace pelt::wasm
