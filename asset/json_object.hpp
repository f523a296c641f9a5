#pragma once

/// Typed reading of JSON from strangers. A field that has the wrong type or is out of range is
/// noted once, with its path in the file, and reads as its default; whoever reads a whole object
/// checks for the first error at the end.

#include <pelt/result.hpp>

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pelt::asset {

/// Keeps the first error of a stage of reading.
class FirstError {
 public:
  void set(Error error);
  const std::optional<Error>& get() const { return error_; }

 private:
  std::optional<Error> error_;
};

/// An object in a JSON text, borrowed, and the path that names it in messages.
class JsonObject {
 public:
  /// `value` may be anything; what is no object is noted as an error and reads as empty.
  JsonObject(const nlohmann::json& value, std::string path, FirstError& errors);

  bool has(const char* key) const;
  bool is_object(const char* key) const;
  bool is_list_of_texts(const char* key) const;
  std::vector<std::string> keys() const;

  std::string text(const char* key) const;  ///< "" where absent
  bool flag(const char* key) const;         ///< false where absent
  float number(const char* key, float otherwise) const;

  /// A whole number that is not negative.
  std::uint64_t count(const char* key) const;
  std::uint64_t count(const char* key, std::uint64_t otherwise) const;

  /// A number of an array that has `size` elements.
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

  JsonObject object(const char* key) const;  ///< empty where absent
  std::vector<JsonObject> objects(const char* key) const;
  std::size_t array_size(const char* key) const;

  /// Notes that `key` breaks a rule: "path.key: what".
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

/// Takes a parsed text apart when it ends, from the leaves up. The destructor of nlohmann::json
/// allocates to do the same, and ends the program where memory has ended.
class JsonEnd {
 public:
  explicit JsonEnd(Result<nlohmann::json>& json) : json_(json) {}
  ~JsonEnd();
  JsonEnd(const JsonEnd&) = delete;
  JsonEnd& operator=(const JsonEnd&) = delete;

 private:
  Result<nlohmann::json>& json_;
};

/// Parses a whole JSON text. Refuses one nested deeper than any glTF file needs, before it costs
/// stack or memory.
Result<nlohmann::json> parse_json(std::string_view text);

}  // namespace pelt::asset
