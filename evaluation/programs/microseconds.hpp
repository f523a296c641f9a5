#pragma once

#include <chrono>

namespace pelt::programs {

/// Duration of `work()`.
template <typename Work>
double microseconds(const Work& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin)
      .count();
}

}  // namespace pelt::programs
