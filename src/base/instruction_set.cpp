#include <pelt/config.hpp>

#include "base/assert.hpp"
#include "base/dispatch.hpp"

#include <vector>

namespace pelt {
namespace detail {

namespace {

struct Built {
  InstructionSet set;
  bool (*runs_here)();
};

constexpr Built kBuilt[] = {
#ifdef PELT_HAS_SCALAR
    {InstructionSet::scalar, [] { return true; }},
#endif
#ifdef PELT_HAS_SIMD128
#if defined(__x86_64__) || defined(__i386__)
    {InstructionSet::simd128, [] { return __builtin_cpu_supports("sse4.1") != 0; }},
#else
    {InstructionSet::simd128, [] { return true; }},
#endif
#endif
#ifdef PELT_HAS_AVX2
    {InstructionSet::avx2, [] { return __builtin_cpu_supports("avx2") != 0; }},
#endif
};

const Built& fastest() {
  const Built* best = kBuilt;
  for (const Built& built : kBuilt)
    if (built.runs_here()) best = &built;
  return *best;
}

}  // namespace

constinit std::atomic<int> active_set{kNotChosen};

InstructionSet choose_instruction_set() {
  int expected = kNotChosen;
  const InstructionSet best = fastest().set;
  return active_set.compare_exchange_strong(expected, static_cast<int>(best))
             ? best
             : static_cast<InstructionSet>(expected);
}

}  // namespace detail

const char* name_of(InstructionSet set) {
  switch (set) {
    case InstructionSet::scalar:
      return "scalar";
    case InstructionSet::simd128:
      return "simd128";
    case InstructionSet::avx2:
      return "avx2";
  }
  PELT_ASSERT(false);
  return "";
}

std::span<const InstructionSet> available_instruction_sets() {
  static const std::vector<InstructionSet> available = [] {
    std::vector<InstructionSet> found;
    for (const detail::Built& built : detail::kBuilt)
      if (built.runs_here()) found.push_back(built.set);
    return found;
  }();
  return available;
}

InstructionSet active_instruction_set() { return detail::active(); }

bool set_active_instruction_set(InstructionSet set) {
  for (const detail::Built& built : detail::kBuilt)
    if (built.set == set && built.runs_here()) {
      detail::active_set.store(static_cast<int>(set));
      return true;
    }
  return false;
}

}  // namespace pelt
