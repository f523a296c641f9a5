#pragma once

/// Lets tests choose when memory allocation fails. Link pelt_failing_allocation, which replaces
/// operator new by one that counts and can fail.

#include <cstddef>
#include <new>

namespace pelt::test {

/// Number of allocated blocks that have not been deleted.
std::ptrdiff_t live_allocations();

/// Makes allocation `number` fail, counted from 1 for the next one, on any thread. With `for_ever`,
/// all later allocations fail too, until this object is destroyed.
class FailingAllocation {
 public:
  explicit FailingAllocation(std::size_t number, bool for_ever = false);
  ~FailingAllocation();
  FailingAllocation(const FailingAllocation&) = delete;
  FailingAllocation& operator=(const FailingAllocation&) = delete;

  bool has_failed() const;
};

/// Calls `operation` again and again, with its first allocation failing, then its second and so on,
/// until one call needs no more than were granted. Calls `check_after_failure` after each
/// `std::bad_alloc`. Returns how many calls failed.
///
/// An operation may also report want of memory otherwise, or do without the memory: what it says
/// then is its own concern.
template <typename Operation, typename Check>
std::size_t fail_each_allocation(const Operation& operation, const Check& check_after_failure,
                                 bool for_ever = false) {
  for (std::size_t number = 1;; ++number) {
    bool has_failed = false, has_thrown = false;
    {
      const FailingAllocation failing(number, for_ever);
      try {
        operation();
      } catch (const std::bad_alloc&) {
        has_thrown = true;
      }
      has_failed = failing.has_failed();
    }
    if (has_thrown) check_after_failure();
    if (!has_failed) return number - 1;
  }
}

}  // namespace pelt::test
