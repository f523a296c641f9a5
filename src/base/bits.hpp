#pragma once

#include <cstring>

namespace pelt::detail {

/// std::bit_cast, which the standard library of Emscripten does not have yet.
template <typename To, typename From>
To bits_as(const From& from) {
  static_assert(sizeof(To) == sizeof(From));
  To to;
  std::memcpy(&to, &from, sizeof(to));
  return to;
}

}  // namespace pelt::detail
