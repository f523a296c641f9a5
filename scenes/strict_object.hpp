#pragma once

/// Reads JSON objects with known keys only. The first error is recorded with its place in the file
/// ("instances[3].rotation: expected 4 numbers, found 3"), and invalid fields return their default.
/// Check for the error after reading a whole file.

#include <pelt/result.hpp>

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pelt::scenes {

/// Allowed values of a number.
struct Range {
  double least, most;
};

class StrictObject {
 public:
  using Problem = std::optional<std::string>;

  /// `value` may have any type. `path` is its place in messages; "" is the whole file.
  StrictObject(const nlohmann::json& value, std::string path,
               std::span<const std::string_view> keys, Problem& problem);

  bool has(std::string_view key) const { return find(key) != nullptr; }

  /// Returns the value, or null if it is absent.
  const nlohmann::json* find(std::string_view key) const;

  /// Returns a string, or nothing if it is absent or null.
  std::optional<std::string> text(std::string_view key) const;
  double number(std::string_view key, double otherwise, Range range) const;
  std::uint32_t count(std::string_view key, std::uint32_t otherwise, Range range) const;

  template <std::size_t N>
  std::array<double, N> numbers(std::string_view key, std::array<double, N> otherwise) const {
    read_numbers(key, otherwise);
    return otherwise;
  }

  StrictObject object(std::string_view key, std::span<const std::string_view> keys) const;
  std::vector<StrictObject> objects(std::string_view key,
                                    std::span<const std::string_view> keys) const;

  /// Returns an object with at least one member, whose keys are names of the file.
  const nlohmann::json& members(std::string_view key) const;

  /// Records an error if `key` is missing.
  void require(std::string_view key) const;
  void refuse(std::string_view key, const std::string& why) const;
  std::string path_of(std::string_view key) const;

 private:
  void read_numbers(std::string_view key, std::span<double> values) const;
  void refuse_unknown_keys(std::span<const std::string_view> keys) const;

  const nlohmann::json* value_;
  std::string path_;
  Problem* problem_;
};

/// Returns the JSON type of a value for messages: "an array", "a string" ...
std::string kind_of(const nlohmann::json& value);

}  // namespace pelt::scenes
