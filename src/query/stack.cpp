#include "query/stack.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <limits>
#include <utility>

namespace pelt::detail {

void StackMemory::grow(std::size_t item_bytes) {
  reserve(std::max<std::size_t>(64, 2 * capacity_), item_bytes);
}

/// The product must not wrap around. No machine has kMax bytes, so `new` then throws.
void StackMemory::reserve(std::size_t capacity, std::size_t item_bytes) {
  constexpr std::size_t kMax = std::numeric_limits<std::ptrdiff_t>::max();
  if (capacity <= capacity_) return;
  const std::size_t size = capacity <= kMax / item_bytes ? capacity * item_bytes : kMax;
  std::unique_ptr<std::byte[]> bytes(new std::byte[size]);
  if (size_ > 0) std::memcpy(bytes.get(), bytes_.get(), size_ * item_bytes);
  bytes_ = std::move(bytes);
  capacity_ = capacity;
}

}  // namespace pelt::detail
