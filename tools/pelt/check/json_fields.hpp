#pragma once

/// Values of JSON: one function writes any value, one reads it and returns whether it is good.

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pelt::tools::check {

template <typename T>
nlohmann::ordered_json to_json(const T& value) {
  return value;
}

/// Null if there is no value.
template <typename T>
nlohmann::ordered_json to_json(const std::optional<T>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

inline bool read(const nlohmann::json& value, bool& to) {
  if (value.is_boolean()) to = value.get<bool>();
  return value.is_boolean();
}

inline bool read(const nlohmann::json& value, std::uint64_t& to) {
  if (value.is_number_unsigned()) to = value.get<std::uint64_t>();
  return value.is_number_unsigned();
}

inline bool read(const nlohmann::json& value, std::uint32_t& to) {
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() > 0xFFFFFFFF) return false;
  to = value.get<std::uint32_t>();
  return true;
}

/// A finite number.
inline bool read(const nlohmann::json& value, double& to) {
  if (!value.is_number()) return false;
  to = value.get<double>();
  return std::isfinite(to);
}

inline bool read(const nlohmann::json& value, std::string& to) {
  if (value.is_string()) to = value.get<std::string>();
  return value.is_string();
}

template <typename T>
bool read(const nlohmann::json& value, std::optional<T>& to) {
  to.reset();
  return value.is_null() || read(value, to.emplace());
}

template <typename T>
bool read(const nlohmann::json& value, std::vector<T>& to) {
  to.clear();
  return value.is_array() &&
         std::all_of(value.begin(), value.end(),
                     [&](const nlohmann::json& one) { return read(one, to.emplace_back()); });
}

/// The value of a key; null if `object` is no object, or has no such key.
inline const nlohmann::json& value_of(const nlohmann::json& object, const std::string& key) {
  static const nlohmann::json kNull;
  if (!object.is_object()) return kNull;
  const auto found = object.find(key);
  return found == object.end() ? kNull : *found;
}

}  // namespace pelt::tools::check
