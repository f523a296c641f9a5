#include "asset/transform.hpp"

#include <cmath>

namespace pelt::asset {

bool normalise(std::array<float, 4>& rotation) {
  double squared = 0;
  for (const float component : rotation) squared += double{component} * component;
  if (!(std::abs(squared - 1) <= 1.0 / 16)) return false;
  const double length = std::sqrt(squared);
  for (float& component : rotation) component = static_cast<float>(component / length);
  return true;
}

bool make_affine(Matrix4& matrix) {
  constexpr float kLastRow[4] = {0, 0, 0, 1};
  for (int column = 0; column < 4; ++column) {
    float& element = matrix.m[4 * column + 3];
    if (!(std::abs(element - kLastRow[column]) <= 0x1p-10f)) return false;
    element = kLastRow[column];
  }
  return true;
}

}  // namespace pelt::asset
