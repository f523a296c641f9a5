#include <pelt/target.hpp>

#include "base/assert.hpp"

#include <atomic>
#include <vector>

namespace pelt {
namespace detail {

namespace {

struct Built {
  Target target;
  bool (*runs_here)();
};

constexpr Built kBuilt[] = {
#ifdef PELT_HAS_SCALAR
    {Target::scalar, [] { return true; }},
#endif
#ifdef PELT_HAS_SIMD128
#if defined(__x86_64__) || defined(__i386__)
    {Target::simd128, [] { return __builtin_cpu_supports("sse4.1") != 0; }},
#else
    {Target::simd128, [] { return true; }},
#endif
#endif
#ifdef PELT_HAS_AVX2
    {Target::avx2, [] { return __builtin_cpu_supports("avx2") != 0; }},
#endif
};

const Built& fastest() {
  const Built* best = kBuilt;
  for (const Built& built : kBuilt)
    if (built.runs_here()) best = &built;
  return *best;
}

std::atomic<const Built*>& active() {
  static std::atomic<const Built*> built = &fastest();
  return built;
}

}  // namespace

}  // namespace detail

const char* name_of(Target target) {
  switch (target) {
    case Target::scalar:
      return "scalar";
    case Target::simd128:
      return "simd128";
    case Target::avx2:
      return "avx2";
  }
  PELT_ASSERT(false);
  return "";
}

std::span<const Target> available_targets() {
  static const std::vector<Target> available = [] {
    std::vector<Target> found;
    for (const detail::Built& built : detail::kBuilt)
      if (built.runs_here()) found.push_back(built.target);
    return found;
  }();
  return available;
}

Target active_target() { return detail::active().load(std::memory_order_relaxed)->target; }

bool set_active_target(Target target) {
  for (const detail::Built& built : detail::kBuilt)
    if (built.target == target && built.runs_here()) {
      detail::active().store(&built);
      return true;
    }
  return false;
}

}  // namespace pelt
