#pragma once

#include <pelt/config.hpp>

#include <string>
#include <utility>
#include <variant>

namespace pelt {

enum class ErrorCode {
  invalid_argument,  ///< an array or option of the caller is invalid
  unreadable_file,   ///< a file is missing or cannot be read or written
  malformed_file,    ///< a file violates its format
  unsupported,       ///< a file is well-formed but needs a feature that Pelt does not support
};

/// A problem with input. The message names the cause (file, array, index, value) and the remedy, if
/// there is one.
struct Error {
  ErrorCode code = ErrorCode::invalid_argument;
  std::string message;
};

/// A value, or the error that explains why there is none. Functions that depend on outside input
/// return a Result. Violated preconditions are not reported in a Result (see pelt/pelt.hpp).
template <typename T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

  explicit operator bool() const { return state_.index() == 0; }

  /// Precondition of the accessors below: the Result holds a value.
  T& operator*() & { return std::get<0>(state_); }
  const T& operator*() const& { return std::get<0>(state_); }
  T&& operator*() && { return std::get<0>(std::move(state_)); }
  T* operator->() { return &std::get<0>(state_); }
  const T* operator->() const { return &std::get<0>(state_); }

  /// Precondition: the Result holds an error.
  const Error& error() const { return std::get<1>(state_); }

 private:
  std::variant<T, Error> state_;
};

/// Success, or an error.
template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : failed_(true), error_(std::move(error)) {}

  explicit operator bool() const { return !failed_; }

  /// Precondition: the Result holds an error.
  const Error& error() const { return error_; }

 private:
  bool failed_ = false;
  Error error_;
};

}  // namespace pelt
