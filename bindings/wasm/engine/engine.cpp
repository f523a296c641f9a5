/// The engine itself: its version and its memory.

#include <pelt/version.hpp>

#include "bindings/wasm/engine/answer.hpp"

#include <malloc.h>

namespace pelt::wasm {

PELT_EXPORT const char* pelt_version() { return PELT_VERSION; }

PELT_EXPORT std::uint32_t pelt_bytes_in_use() {
  return static_cast<std::uint32_t>(mallinfo().uordblks);
}

}  // namespace pelt::wasm
