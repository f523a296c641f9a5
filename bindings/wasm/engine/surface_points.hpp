#pragma once

#include <pelt/distance.hpp>

#include "bindings/wasm/engine/handles.hpp"

#include <initializer_list>

namespace pelt::wasm {

struct PointOfPose {
  const SurfacePoint& point;
  const PoseHandle& pose;
};

/// The answer is these points, seven numbers each: triangle, position, weights of the triangle's
/// vertices.
void answer_points(std::initializer_list<PointOfPose> points);

}  // namespace pelt::wasm
