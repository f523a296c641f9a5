#pragma once

#include <cstdint>

namespace pelt::test {

/// A case that at least one seed of a fuzz target must reach: a query that is asked, or a kind of
/// answer. Define each goal as a static object; `TARGET_replay --reach-all` fails if one of them
/// was not reached.
class Goal {
 public:
  explicit Goal(const char* name) : name_(name), next_(first_) { first_ = this; }

  /// Counts one case if `condition` holds.
  void reach(bool condition = true) { count_ += condition ? 1 : 0; }

  const char* name() const { return name_; }
  std::uint64_t count() const { return count_; }

  /// All goals of the program, as a list.
  static const Goal* first() { return first_; }
  const Goal* next() const { return next_; }

 private:
  const char* name_;
  const Goal* next_;
  std::uint64_t count_ = 0;
  static inline const Goal* first_ = nullptr;
};

}  // namespace pelt::test
