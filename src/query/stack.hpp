#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>

namespace pelt::detail {

/// A growing stack of plain values, for code that is compiled for several targets: pushing is
/// inline, and the growing stands in one file (scratch.cpp names the types).
template <typename T>
class Stack {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  using value_type = T;

  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  std::size_t capacity() const { return capacity_; }
  void clear() { size_ = 0; }
  void shrink(std::size_t size) { size_ = size < size_ ? size : size_; }
  T* begin() { return items_.get(); }
  T* end() { return items_.get() + size_; }

  void push(const T& item) {
    if (size_ == capacity_) grow();
    items_[size_++] = item;
  }

  /// Precondition: not empty.
  T pop() { return items_[--size_]; }

  /// Makes room for that many items in all.
  void reserve(std::size_t capacity);

 private:
  void grow();

  std::unique_ptr<T[]> items_;
  std::size_t size_ = 0, capacity_ = 0;
};

}  // namespace pelt::detail
