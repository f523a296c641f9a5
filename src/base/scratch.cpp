#include "base/scratch.hpp"

#include <algorithm>

namespace pelt::detail {

template <typename T>
void Stack<T>::grow() {
  reserve(std::max<std::size_t>(64, 2 * capacity_));
}

template <typename T>
void Stack<T>::reserve(std::size_t capacity) {
  if (capacity <= capacity_) return;
  std::unique_ptr<T[]> items(new T[capacity]);
  std::copy_n(items_.get(), size_, items.get());
  items_ = std::move(items);
  capacity_ = capacity;
}

template class Stack<SlotPair>;
template class Stack<Contact>;

}  // namespace pelt::detail
