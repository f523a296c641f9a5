#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <type_traits>

namespace pelt::detail {

/// The memory of a Stack, whatever the type of its items. It grows in one baseline file, so that
/// code compiled for several instruction sets instantiates nothing that the linker could share
/// between them.
class StackMemory {
 public:
  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  std::size_t capacity() const { return capacity_; }
  void clear() { size_ = 0; }
  void shrink(std::size_t size) { size_ = size < size_ ? size : size_; }

 protected:
  /// Makes room for at least one more item.
  void grow(std::size_t item_bytes);
  /// Makes room for `capacity` items in all.
  void reserve(std::size_t capacity, std::size_t item_bytes);

  std::unique_ptr<std::byte[]> bytes_;
  std::size_t size_ = 0, capacity_ = 0;
};

/// A growing stack of plain values.
template <typename T>
class Stack : public StackMemory {
  static_assert(std::is_trivially_copyable_v<T>);
  static_assert(alignof(T) <= __STDCPP_DEFAULT_NEW_ALIGNMENT__);

 public:
  using value_type = T;

  const T* begin() const { return reinterpret_cast<const T*>(bytes_.get()); }
  T* begin() { return reinterpret_cast<T*>(bytes_.get()); }
  const T* end() const { return begin() + size_; }
  T* end() { return begin() + size_; }

  [[gnu::always_inline]] void push(const T& item) {
    if (size_ == capacity_) grow(sizeof(T));
    begin()[size_++] = item;
  }

  /// Replaces all items by `size` copies of one.
  void assign(std::size_t size, const T& item) {
    reserve(size);
    size_ = size;
    std::fill_n(begin(), size, item);
  }

  /// Precondition: not empty.
  T pop() { return begin()[--size_]; }

  /// Makes room for `capacity` items in all.
  void reserve(std::size_t capacity) { StackMemory::reserve(capacity, sizeof(T)); }
};

}  // namespace pelt::detail
