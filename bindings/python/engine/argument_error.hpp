#pragma once

#include <pelt/result.hpp>

#include <stdexcept>
#include <string>
#include <utility>

namespace pelt::python {

/// A problem with an argument. Python sees it as `pelt.Error`.
class ArgumentError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Returns the value of `result`. If there is none, throws an error whose message starts with
/// `place`, for example "palettes_a, frame 3".
template <class T>
T value_of(Result<T> result, const std::string& place) {
  if (!result) throw ArgumentError(place + ": " + result.error().message);
  return *std::move(result);
}

inline void check(const Result<void>& result, const std::string& place) {
  if (!result) throw ArgumentError(place + ": " + result.error().message);
}

}  // namespace pelt::python
