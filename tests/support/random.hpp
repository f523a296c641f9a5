#pragma once

#include <pelt/math.hpp>

#include <cstdint>
#include <cstdio>
#include <random>

namespace pelt::test {

/// Random numbers that are the same on every platform (the standard's distributions are not).
/// Prints its seed, so that a failure can be repeated.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {
    std::printf("seed %llu\n", static_cast<unsigned long long>(seed));
  }

  std::uint64_t bits() { return engine_(); }

  /// In [0, 1).
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

  double uniform(double low, double high) { return low + (high - low) * unit(); }
  float uniformf(double low, double high) { return static_cast<float>(uniform(low, high)); }

  /// In [0, count).
  std::uint32_t index(std::uint32_t count) { return static_cast<std::uint32_t>(bits() % count); }

  bool chance(double probability) { return unit() < probability; }

  Vec3 point(double half_size) {
    return {uniformf(-half_size, half_size), uniformf(-half_size, half_size),
            uniformf(-half_size, half_size)};
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace pelt::test
