#include "bindings/python/engine/contact_hash.hpp"

namespace pelt::python {
namespace {

class Fnv1a64 {
 public:
  void add(std::uint32_t word) {
    for (int shift = 0; shift < 32; shift += 8)
      state_ = (state_ ^ static_cast<std::uint8_t>(word >> shift)) * 0x100000001b3u;
  }

  std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325u;
};

}  // namespace

std::uint64_t contact_hash(const Column& frames, const Column& triangles_a,
                           const Column& triangles_b, const Column& bodies_a,
                           const Column& bodies_b) {
  check_shape(triangles_a, "triangle_a", {frames.size()}, "[N]");
  check_shape(triangles_b, "triangle_b", {frames.size()}, "[N]");
  check_shape(bodies_a, "bodies_a", {frames.size()}, "[N]");
  check_shape(bodies_b, "bodies_b", {frames.size()}, "[N]");
  Fnv1a64 hash;
  for (py::ssize_t i = 0; i < frames.size(); ++i) {
    hash.add(static_cast<std::uint32_t>(frames.at(i)));
    hash.add(static_cast<std::uint32_t>(bodies_a.at(i)));
    hash.add(static_cast<std::uint32_t>(bodies_b.at(i)));
    hash.add(static_cast<std::uint32_t>(triangles_a.at(i)));
    hash.add(static_cast<std::uint32_t>(triangles_b.at(i)));
  }
  return hash.value();
}

}  // namespace pelt::python
