#pragma once

namespace pelt::paper {

/// Asks for the memory at `p` ahead of its use. Changes no result.
template <typename T>
void prefetch(const T* p) {
  __builtin_prefetch(p);
}

}  // namespace pelt::paper
