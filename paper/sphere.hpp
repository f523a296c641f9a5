#pragma once

#include <pelt/math.hpp>

namespace pelt::paper {

struct Sphere {
  Vec3 centre;
  float radius = 0;
};

}  // namespace pelt::paper
