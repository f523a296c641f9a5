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

/// Calls `operation` repeatedly, with its first allocation failing, then its second and so on,
/// until a call needs no more allocations than were granted. Calls `check_after_failure` after each
/// `std::bad_alloc`. Returns the number of failed calls.
///
/// An operation may also report the failure in another way, or continue without the memory; its
/// result is then not checked.
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
