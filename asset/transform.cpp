#include "asset/transform.hpp"

#include "base/assert.hpp"

#include <cmath>

namespace pelt::asset {

// x - x^3/3! + x^5/5! ... to x^21/21!. The series alternates, so the error is below the first
// omitted term: (pi/2)^23 / 23! < 2e-18. The rest is rounding.
double sine(double x) {
  PELT_ASSERT(x >= -kPi / 2 - 1e-9 && x <= kPi / 2 + 1e-9);
  const double x2 = x * x;
  double factor = 1;
  for (int n = 20; n >= 2; n -= 2) factor = 1 - x2 / (n * (n + 1)) * factor;
  return x * factor;
}

double sine_of_turns(double turns) {
  PELT_ASSERT(turns > -1073741824.0 && turns < 1073741824.0);
  double t = turns - std::floor(turns + 0.5);
  if (t > 0.25) t = 0.5 - t;
  if (t < -0.25) t = -0.5 - t;
  return sine(2 * kPi * t);
}

double cosine_of_turns(double turns) { return sine_of_turns(turns + 0.25); }

// Three applications of tan(a/2) = sin a / (1 + cos a) reduce the angle below pi/16, where the
// alternating series x - x^3/3 + x^5/5 ... to x^25/25 has an error below tan(pi/16)^27 / 27 <
// 5e-21.
double angle_of(double sine, double cosine) {
  PELT_ASSERT(sine >= 0 && cosine >= 0 && sine + cosine > 0);
  double x = sine / (cosine + std::sqrt(sine * sine + cosine * cosine));
  for (int halving = 0; halving < 2; ++halving) x = x / (1 + std::sqrt(1 + x * x));
  const double x2 = x * x;
  double sum = 0;
  for (int n = 25; n >= 1; n -= 2) sum = 1.0 / n - x2 * sum;
  return 8 * x * sum;
}

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
