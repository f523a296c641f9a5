#include "scenes/strict_object.hpp"

#include "text/message.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace pelt::scenes {
namespace {

using nlohmann::json;

const json& empty_object() {
  static const json empty = json::object();
  return empty;
}

std::string shown(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.12g", value);
  return text;
}

std::string expected(Range range) {
  return "expected " + shown(range.least) + " to " + shown(range.most);
}

bool holds(Range range, double value) { return value >= range.least && value <= range.most; }

}  // namespace

std::string kind_of(const json& value) {
  if (value.is_array()) return "an array";
  if (value.is_object()) return "an object";
  if (value.is_string()) return "a string";
  if (value.is_boolean()) return "true or false";
  return value.is_null() ? "null" : "a number";
}

StrictObject::StrictObject(const json& value, std::string path,
                           std::span<const std::string_view> keys, Problem& problem)
    : value_(&value), path_(std::move(path)), problem_(&problem) {
  if (value.is_object()) {
    refuse_unknown_keys(keys);
  } else {
    refuse("", "expected an object, found " + kind_of(value));
    value_ = &empty_object();
  }
}

std::optional<std::string> StrictObject::text(std::string_view key) const {
  const json* value = find(key);
  if (value == nullptr || value->is_null()) return std::nullopt;
  if (value->is_string()) return value->get<std::string>();
  refuse(key, "expected a string, found " + kind_of(*value));
  return std::nullopt;
}

double StrictObject::number(std::string_view key, double otherwise, Range range) const {
  const json* value = find(key);
  if (value == nullptr) return otherwise;
  if (!value->is_number()) {
    refuse(key, "expected a number, found " + kind_of(*value));
    return otherwise;
  }
  const double number = value->get<double>();
  if (holds(range, number)) return number;
  refuse(key, expected(range) + ", found " + shown(number));
  return otherwise;
}

std::uint32_t StrictObject::count(std::string_view key, std::uint32_t otherwise,
                                  Range range) const {
  const double value = number(key, otherwise, range);
  if (value == std::floor(value)) return static_cast<std::uint32_t>(value);
  refuse(key, "expected a whole number, found " + shown(value));
  return otherwise;
}

StrictObject StrictObject::object(std::string_view key,
                                  std::span<const std::string_view> keys) const {
  const json* value = find(key);
  return StrictObject(value == nullptr ? empty_object() : *value, path_of(key), keys, *problem_);
}

std::vector<StrictObject> StrictObject::objects(std::string_view key,
                                                std::span<const std::string_view> keys) const {
  std::vector<StrictObject> elements;
  const json* array = find(key);
  if (array == nullptr) return elements;
  if (!array->is_array()) refuse(key, "expected an array, found " + kind_of(*array));
  for (std::size_t i = 0; array->is_array() && i < array->size(); ++i) {
    elements.emplace_back((*array)[i], path_of(key) + "[" + std::to_string(i) + "]", keys,
                          *problem_);
  }
  return elements;
}

const json& StrictObject::members(std::string_view key) const {
  const json* value = find(key);
  if (value == nullptr) return empty_object();
  if (value->is_object() && !value->empty()) return *value;
  refuse(key, value->is_object() ? "expected at least one member, found none"
                                 : "expected an object, found " + kind_of(*value));
  return empty_object();
}

void StrictObject::require(std::string_view key) const {
  if (!has(key)) refuse(key, "is missing");
}

void StrictObject::refuse(std::string_view key, const std::string& why) const {
  if (*problem_) return;
  const std::string place = key.empty() ? path_ : path_of(key);
  *problem_ = place.empty() ? why : place + ": " + why;
}

std::string StrictObject::path_of(std::string_view key) const {
  return path_.empty() ? std::string(key) : path_ + "." + std::string(key);
}

const json* StrictObject::find(std::string_view key) const {
  const auto member = value_->find(std::string(key));
  return member == value_->end() ? nullptr : &*member;
}

void StrictObject::read_numbers(std::string_view key, std::span<double> values) const {
  const json* array = find(key);
  if (array == nullptr) return;
  const std::string wanted = "expected " + std::to_string(values.size()) + " numbers, found ";
  if (!array->is_array()) return refuse(key, wanted + kind_of(*array));
  if (array->size() != values.size()) return refuse(key, wanted + std::to_string(array->size()));
  for (std::size_t i = 0; i < values.size(); ++i) {
    const json& element = (*array)[i];
    if (!element.is_number()) return refuse(key, wanted + kind_of(element) + " among them");
    values[i] = element.get<double>();
  }
}

void StrictObject::refuse_unknown_keys(std::span<const std::string_view> keys) const {
  for (auto member = value_->begin(); member != value_->end(); ++member) {
    const std::string& key = member.key();
    if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
    refuse("", "unknown key " + text::quoted(key) + text::suggestion(key, keys));
  }
}

}  // namespace pelt::scenes
