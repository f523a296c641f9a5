#pragma once

/// Typed reading of untrusted JSON. A field with the wrong type or out of range is recorded as an
/// error with its path in the file, and returns its default. Check for the first error after
/// reading a whole object.

#include <pelt/result.hpp>

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pelt::asset {

/// Stores the first error of a stage of reading.
class FirstError {
 public:
  void set(Error error);
  const std::optional<Error>& get() const { return error_; }

 private:
  std::optional<Error> error_;
};

/// A borrowed object in a JSON text, with its path for messages.
class JsonObject {
 public:
  /// `value` may have any type. Anything but an object is recorded as an error and treated as
  /// empty.
  JsonObject(const nlohmann::json& value, std::string path, FirstError& errors);

  bool has(const char* key) const;
  bool is_object(const char* key) const;
  bool is_list_of_texts(const char* key) const;
  std::vector<std::string> keys() const;

  std::string text(const char* key) const;  ///< "" if absent
  bool flag(const char* key) const;         ///< false if absent
  float number(const char* key, float otherwise) const;

  /// Returns a whole number that is not negative.
  std::uint64_t count(const char* key) const;
  std::uint64_t count(const char* key, std::uint64_t otherwise) const;

  /// Returns an index into an array with `size` elements.
  std::uint32_t index(const char* key, std::size_t size) const;
  std::optional<std::uint32_t> optional_index(const char* key, std::size_t size) const;
  std::vector<std::uint32_t> indices(const char* key, std::size_t size) const;

  std::vector<float> floats(const char* key) const;
  std::vector<std::string> texts(const char* key) const;

  template <std::size_t N>
  std::array<float, N> floats(const char* key, const std::array<float, N>& otherwise) const {
    std::array<float, N> values = otherwise;
    read_floats(key, values.data(), N);
    return values;
  }

  JsonObject object(const char* key) const;  ///< empty if absent
  std::vector<JsonObject> objects(const char* key) const;
  std::size_t array_size(const char* key) const;

  /// Records an error of `key`: "path.key: what".
  void refuse(const char* key, const std::string& what) const;
  void refuse_as_unsupported(const char* key, const std::string& what) const;

 private:
  const nlohmann::json* find(const char* key) const;
  const nlohmann::json* array(const char* key) const;
  void read_floats(const char* key, float* values, std::size_t count) const;
  std::string path_of(const char* key) const;
  std::string path_of(const char* key, std::size_t element) const;
  void require_index(std::uint64_t value, std::size_t size, const std::string& path) const;

  const nlohmann::json* value_;
  std::string path_;
  FirstError* errors_;
};

}  // namespace pelt::asset
