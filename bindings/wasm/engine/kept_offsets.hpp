#pragma once

#include <pelt/math.hpp>

#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace pelt::wasm {

/// The offsets of an instance of a crowd, which borrows them: those that were set last, and those
/// at the start of the step. A move changes no address of an offset.
class KeptOffsets {
 public:
  /// Copies offsets in a step, and returns the copy. Keeps the copy before it if the start of the
  /// step may borrow it.
  std::span<const Vec3> keep(std::span<const Vec3> offsets, std::uint64_t step) {
    if (step != step_) std::swap(last_, start_);
    step_ = step;
    last_.assign(offsets.begin(), offsets.end());
    return last_;
  }

  /// Call when the start of the step has borrowed the offsets that were set last.
  void start_borrows() { step_ = std::numeric_limits<std::uint64_t>::max(); }

 private:
  std::vector<Vec3> last_, start_;
  std::uint64_t step_ = 0;  // in which `last_` was set
};

}  // namespace pelt::wasm
