#pragma once

#include <memory>
#include <mutex>

namespace pelt::detail {

/// A value that the first call of `get` makes, once, also if several threads call it. A copy starts
/// without a value. If making it throws, the next call tries again.
template <typename T>
class MadeOnce {
 public:
  MadeOnce() = default;
  MadeOnce(const MadeOnce&) noexcept {}
  MadeOnce& operator=(const MadeOnce&) = delete;

  /// `make` returns a std::shared_ptr<const T>, whose deleter is known where T is complete.
  template <typename Make>
  const T& get(const Make& make) const {
    std::call_once(is_made_, [&] { value_ = make(); });
    return *value_;
  }

 private:
  mutable std::once_flag is_made_;
  mutable std::shared_ptr<const T> value_;
};

}  // namespace pelt::detail
