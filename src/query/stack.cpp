#include "query/stack.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

namespace pelt::detail {

void StackMemory::grow(std::size_t item_bytes) {
  reserve(std::max<std::size_t>(64, 2 * capacity_), item_bytes);
}

void StackMemory::reserve(std::size_t capacity, std::size_t item_bytes) {
  if (capacity <= capacity_) return;
  std::unique_ptr<std::byte[]> bytes(new std::byte[capacity * item_bytes]);
  if (size_ > 0) std::memcpy(bytes.get(), bytes_.get(), size_ * item_bytes);
  bytes_ = std::move(bytes);
  capacity_ = capacity;
}

}  // namespace pelt::detail
