#pragma once

/// Exports functions of the engine to JavaScript. JavaScript (memory.mjs) writes the arguments as
/// numbers: an object of the engine is its address; a text or an array is the address of a copy
/// and its size in bytes. The function gets them as its parameters. Its result becomes a number
/// again: the work of a query is stored in the answer, and an error is NaN.

#include <pelt/result.hpp>

#include "bindings/wasm/engine/answer.hpp"

#include <cstdint>
#include <span>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

/// Exports a function without overloads as pelt_NAME.
#define PELT_EXPORT_AS(name, function) \
  PELT_RAW_EXPORT double pelt_##name() { return ::pelt::wasm::call(function); }
#define PELT_EXPORT(name) PELT_EXPORT_AS(name, name)

namespace pelt::wasm {

/// The arguments that JavaScript has written.
const double* arguments();

/// Reads a whole number, and moves on to the next argument. Not inlined, because the conversion is
/// long.
[[gnu::noinline]] std::uint32_t next_whole(const double*& next);

template <typename T>
T* next_object(const double*& next) {
  return reinterpret_cast<T*>(static_cast<std::uintptr_t>(next_whole(next)));
}

/// Reads the arguments of one parameter, and moves on to the next: a number, a yes or no, an enum.
template <typename T>
struct Parameter {
  static T read(const double*& next) {
    if constexpr (std::is_enum_v<T> || std::is_unsigned_v<T>)
      return static_cast<T>(next_whole(next));
    else
      return static_cast<T>(*next++);
  }
};

template <typename T>
struct Parameter<T*> {
  static T* read(const double*& next) { return next_object<T>(next); }
};

template <typename T>
struct Parameter<T&> {
  static T& read(const double*& next) { return *next_object<T>(next); }
};

template <typename T>
struct Parameter<std::span<const T>> {
  static std::span<const T> read(const double*& next) {
    const T* elements = next_object<const T>(next);
    return {elements, next_whole(next) / sizeof(T)};
  }
};

template <>
struct Parameter<std::string_view> {
  static std::string_view read(const double*& next) {
    const std::span<const char> text = Parameter<std::span<const char>>::read(next);
    return {text.data(), text.size()};
  }
};

/// The number that JavaScript gets: the value itself, an address, or, of the work of a query, its
/// yes or no.
template <typename T>
double number_for_javascript(const T& result) {
  if constexpr (std::is_pointer_v<T>) {
    return static_cast<double>(reinterpret_cast<std::uintptr_t>(result));
  } else if constexpr (std::is_base_of_v<QueryStats, T>) {
    answer_stats(result);
    if constexpr (std::is_same_v<T, YesNo>) return result ? 1 : 0;
    return 0;
  } else {
    return static_cast<double>(result);
  }
}

template <typename T>
double number_for_javascript(Result<T> result) {
  if (!result) return refuse(result.error());
  if constexpr (std::is_void_v<T>)
    return 0;
  else
    return number_for_javascript(*result);
}

template <typename R, typename... P>
double call(R (*function)(P...)) {
  [[maybe_unused]] const double* next = arguments();            // unused without parameters
  std::tuple<P...> parameters = {Parameter<P>::read(next)...};  // in this order
  if constexpr (std::is_void_v<R>)
    return std::apply(function, std::move(parameters)), 0;
  else
    return number_for_javascript(std::apply(function, std::move(parameters)));
}

}  // namespace pelt::wasm
