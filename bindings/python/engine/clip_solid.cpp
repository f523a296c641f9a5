#include "bindings/python/engine/clip_solid.hpp"

#include <cmath>
#include <cstring>

namespace pelt::python {
namespace {

using Numbers = const float*;

Vec3 vector_at(Numbers numbers) { return {numbers[0], numbers[1], numbers[2]}; }

void check_not_negative(float number, const char* name) {
  if (number < 0)
    throw ArgumentError(std::string(name) + ": expected 0 or more, found " +
                        std::to_string(number));
}

Solid half_space(Numbers n) {
  if (n[0] == 0 && n[1] == 0 && n[2] == 0) throw ArgumentError("normal: is zero");
  return HalfSpace{vector_at(n), n[3]};
}

Solid box(Numbers n) {
  for (int axis = 0; axis < 3; ++axis)
    if (n[axis] > n[3 + axis]) throw ArgumentError("low: is above high");
  return Box{vector_at(n), vector_at(n + 3)};
}

Solid oriented_box(Numbers n) {
  for (int axis = 0; axis < 3; ++axis) check_not_negative(n[12 + axis], "half");
  return OrientedBox{
      vector_at(n), {vector_at(n + 3), vector_at(n + 6), vector_at(n + 9)}, vector_at(n + 12)};
}

Solid sphere(Numbers n) {
  check_not_negative(n[3], "radius");
  return Sphere{vector_at(n), n[3]};
}

Solid capsule(Numbers n) {
  check_not_negative(n[6], "radius");
  return Capsule{vector_at(n), vector_at(n + 3), n[6]};
}

struct Kind {
  const char* name;
  std::size_t count;
  Solid (*make)(Numbers);
};

constexpr Kind kKinds[] = {{"HalfSpace", 4, half_space},
                           {"Box", 6, box},
                           {"OrientedBox", 15, oriented_box},
                           {"Sphere", 4, sphere},
                           {"Capsule", 7, capsule}};

const Kind& kind_of(const std::string& name) {
  for (const Kind& kind : kKinds)
    if (name == kind.name) return kind;
  throw ArgumentError("solid: there is no kind " + name);
}

Solid make_solid(const Kind& kind, const std::vector<float>& numbers) {
  for (const float number : numbers)
    if (!std::isfinite(number)) throw ArgumentError("has a number that is not a finite float32");
  return kind.make(numbers.data());
}

}  // namespace

ClipSolid::ClipSolid(const std::string& kind_name, const py::array& numbers) {
  const Kind& kind = kind_of(kind_name);
  check_shape(numbers, kind_name, {-1, static_cast<py::ssize_t>(kind.count)},
              "[F, " + std::to_string(kind.count) + "]");
  if (numbers.shape(0) == 0) throw ArgumentError(kind_name + ": there are no frames");
  const FloatView view(numbers, kind_name);
  std::vector<float> members(kind.count);
  for (std::size_t frame = 0; frame < view.size(0); ++frame) {
    view.copy(frame, members.data());
    try {
      solids_.push_back(make_solid(kind, members));
    } catch (const ArgumentError& error) {
      const std::string place = view.size(0) == 1 ? "" : ", frame " + std::to_string(frame);
      throw ArgumentError(kind_name + place + ": " + error.what());
    }
  }
}

}  // namespace pelt::python
