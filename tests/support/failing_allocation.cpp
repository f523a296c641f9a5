#include "support/failing_allocation.hpp"

#include <atomic>
#include <cstdlib>

namespace {

constexpr std::ptrdiff_t kNever = -1;

std::atomic<std::ptrdiff_t> live{0};
std::atomic<std::ptrdiff_t> left{kNever};  // successes before a failure; kNever: all succeed
std::atomic<bool> fails_for_ever{false}, failed{false};

bool is_refused() {
  std::ptrdiff_t before = left.load();
  while (before > 0 && !left.compare_exchange_weak(before, before - 1)) {
  }
  if (before != 0) return false;
  failed = true;
  if (!fails_for_ever) left = kNever;
  return true;
}

void* allocate(std::size_t size, std::size_t alignment) noexcept {
  if (is_refused()) return nullptr;
  const std::size_t rounded = (size + alignment - 1) / alignment * alignment;
  void* memory = std::aligned_alloc(alignment, rounded == 0 ? alignment : rounded);
  if (memory != nullptr) ++live;
  return memory;
}

void* allocate_or_throw(std::size_t size, std::size_t alignment) {
  if (void* memory = allocate(size, alignment)) return memory;
  throw std::bad_alloc();
}

void release(void* memory) {
  if (memory != nullptr) --live;
  std::free(memory);
}

constexpr std::size_t kAlignment = __STDCPP_DEFAULT_NEW_ALIGNMENT__;

}  // namespace

namespace pelt::test {

std::ptrdiff_t live_allocations() { return live; }

FailingAllocation::FailingAllocation(std::size_t number, bool for_ever) {
  failed = false;
  fails_for_ever = for_ever;
  left = static_cast<std::ptrdiff_t>(number) - 1;
}

FailingAllocation::~FailingAllocation() { left = kNever; }

bool FailingAllocation::has_failed() const { return failed; }

}  // namespace pelt::test

// Replaces every form, because a sanitizer has forms of its own that do not call another.
void* operator new(std::size_t size) { return allocate_or_throw(size, kAlignment); }
void* operator new[](std::size_t size) { return allocate_or_throw(size, kAlignment); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocate_or_throw(size, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
  return allocate_or_throw(size, static_cast<std::size_t>(alignment));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return allocate(size, kAlignment);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
  return allocate(size, kAlignment);
}
void operator delete(void* memory) noexcept { release(memory); }
void operator delete[](void* memory) noexcept { release(memory); }
void operator delete(void* memory, std::size_t) noexcept { release(memory); }
void operator delete[](void* memory, std::size_t) noexcept { release(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { release(memory); }
void operator delete[](void* memory, const std::nothrow_t&) noexcept { release(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { release(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { release(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { release(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { release(memory); }
