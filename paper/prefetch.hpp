#pragma once

namespace pelt::paper {

/// Prefetches the memory at `p`. Changes no result.
template <typename T>
void prefetch(const T* p) {
  __builtin_prefetch(p);
}

}  // namespace pelt::paper
