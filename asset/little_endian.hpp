#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace pelt::asset {

static_assert(std::endian::native == std::endian::little, "glTF's bytes are read as they stand");

/// The number that stands at `bytes`, which need not be aligned.
template <typename T>
T load(const std::byte* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

}  // namespace pelt::asset
