#include "asset/json_object.hpp"

#include "text/message.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace pelt::asset {

namespace {

using nlohmann::json;

const json& empty_object() {
  static const json empty = json::object();
  return empty;
}

std::optional<std::uint64_t> whole_number(const json& value) {
  if (value.is_number_unsigned()) return value.get<std::uint64_t>();
  if (value.is_number_integer() && value.get<std::int64_t>() >= 0) {
    return static_cast<std::uint64_t>(value.get<std::int64_t>());
  }
  if (!value.is_number_float()) return std::nullopt;
  constexpr double kLargest = 9007199254740992;  // 2^53, above which doubles skip whole numbers
  const double number = value.get<double>();
  if (!(number >= 0 && number <= kLargest)) return std::nullopt;
  const auto whole = static_cast<std::uint64_t>(number);
  if (static_cast<double>(whole) != number) return std::nullopt;
  return whole;
}

std::optional<float> finite_float(const json& value) {
  if (!value.is_number()) return std::nullopt;
  const double number = value.get<double>();
  constexpr double kLargest = std::numeric_limits<float>::max();
  if (!(number >= -kLargest && number <= kLargest)) return std::nullopt;
  return static_cast<float>(number);
}

}  // namespace

void FirstError::set(Error error) {
  if (!error_) error_ = std::move(error);
}

JsonObject::JsonObject(const json& value, std::string path, FirstError& errors)
    : value_(&value), path_(std::move(path)), errors_(&errors) {
  if (value.is_object()) return;
  errors.set(text::malformed((path_.empty() ? "the JSON text" : path_) + ": must be an object"));
  value_ = &empty_object();
}

bool JsonObject::has(const char* key) const { return find(key) != nullptr; }

std::vector<std::string> JsonObject::keys() const {
  std::vector<std::string> names;
  for (auto it = value_->begin(); it != value_->end(); ++it) names.push_back(it.key());
  return names;
}

std::string JsonObject::text(const char* key) const {
  const json* value = find(key);
  if (!value) return {};
  if (value->is_string()) return value->get<std::string>();
  refuse(key, "must be a string");
  return {};
}

bool JsonObject::flag(const char* key) const {
  const json* value = find(key);
  if (!value) return false;
  if (value->is_boolean()) return value->get<bool>();
  refuse(key, "must be true or false");
  return false;
}

float JsonObject::number(const char* key, float otherwise) const {
  const json* value = find(key);
  if (!value) return otherwise;
  if (const std::optional<float> number = finite_float(*value)) return *number;
  refuse(key, "must be a number that a float can hold");
  return otherwise;
}

std::uint64_t JsonObject::count(const char* key) const {
  if (!has(key)) refuse(key, "is missing");
  return count(key, 0);
}

std::uint64_t JsonObject::count(const char* key, std::uint64_t otherwise) const {
  const json* value = find(key);
  if (!value) return otherwise;
  if (const std::optional<std::uint64_t> number = whole_number(*value)) return *number;
  refuse(key, "must be a whole number, not negative");
  return otherwise;
}

std::uint32_t JsonObject::index(const char* key, std::size_t size) const {
  if (!has(key)) refuse(key, "is missing");
  return optional_index(key, size).value_or(0);
}

std::optional<std::uint32_t> JsonObject::optional_index(const char* key, std::size_t size) const {
  if (!has(key)) return std::nullopt;
  const std::uint64_t value = count(key, 0);
  require_index(value, size, path_of(key));
  return static_cast<std::uint32_t>(value);
}

std::vector<std::uint32_t> JsonObject::indices(const char* key, std::size_t size) const {
  std::vector<std::uint32_t> values;
  const json* elements = array(key);
  for (std::size_t i = 0; elements && i < elements->size(); ++i) {
    const std::uint64_t value = whole_number((*elements)[i]).value_or(UINT64_MAX);
    require_index(value, size, path_of(key, i));
    values.push_back(static_cast<std::uint32_t>(value));
  }
  return values;
}

std::vector<float> JsonObject::floats(const char* key) const {
  std::vector<float> values(array_size(key));
  read_floats(key, values.data(), values.size());
  return values;
}

std::vector<std::string> JsonObject::texts(const char* key) const {
  std::vector<std::string> values;
  const json* elements = array(key);
  for (std::size_t i = 0; elements && i < elements->size(); ++i) {
    if ((*elements)[i].is_string()) {
      values.push_back((*elements)[i].get<std::string>());
    } else {
      errors_->set(text::malformed(path_of(key, i) + ": must be a string"));
    }
  }
  return values;
}

bool JsonObject::is_object(const char* key) const {
  const json* value = find(key);
  return value && value->is_object();
}

bool JsonObject::is_list_of_texts(const char* key) const {
  const json* value = find(key);
  return value && value->is_array() &&
         std::all_of(value->begin(), value->end(), [](const json& e) { return e.is_string(); });
}

JsonObject JsonObject::object(const char* key) const {
  const json* value = find(key);
  return {value ? *value : empty_object(), path_of(key), *errors_};
}

std::vector<JsonObject> JsonObject::objects(const char* key) const {
  std::vector<JsonObject> elements;
  const json* values = array(key);
  for (std::size_t i = 0; values && i < values->size(); ++i) {
    elements.emplace_back((*values)[i], path_of(key, i), *errors_);
  }
  return elements;
}

std::size_t JsonObject::array_size(const char* key) const {
  const json* elements = array(key);
  return elements ? elements->size() : 0;
}

void JsonObject::refuse(const char* key, const std::string& what) const {
  errors_->set(text::malformed(path_of(key) + ": " + what));
}

void JsonObject::refuse_as_unsupported(const char* key, const std::string& what) const {
  errors_->set(text::unsupported(path_of(key) + ": " + what));
}

const json* JsonObject::find(const char* key) const {
  const auto it = value_->find(key);
  return it == value_->end() ? nullptr : &*it;
}

const json* JsonObject::array(const char* key) const {
  const json* value = find(key);
  if (!value || value->is_array()) return value;
  refuse(key, "must be an array");
  return nullptr;
}

void JsonObject::read_floats(const char* key, float* values, std::size_t count) const {
  const json* elements = array(key);
  if (!elements) return;
  if (elements->size() != count) {
    return refuse(key, "must have " + std::to_string(count) + " numbers");
  }
  for (std::size_t i = 0; i < count; ++i) {
    const std::optional<float> number = finite_float((*elements)[i]);
    if (!number) {
      errors_->set(text::malformed(path_of(key, i) + ": must be a number that a float can hold"));
      return;
    }
    values[i] = *number;
  }
}

std::string JsonObject::path_of(const char* key) const {
  return path_.empty() ? key : path_ + "." + key;
}

std::string JsonObject::path_of(const char* key, std::size_t element) const {
  return path_of(key) + "[" + std::to_string(element) + "]";
}

void JsonObject::require_index(std::uint64_t value, std::size_t size,
                               const std::string& path) const {
  if (value < size) return;
  errors_->set(text::malformed(path + ": must be a whole number below " + std::to_string(size) +
                               ", the number of elements there are"));
}

}  // namespace pelt::asset
