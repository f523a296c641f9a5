#pragma once

/// Reading of a JSON object that may hold nothing but known keys. The first thing that is wrong is
/// noted with its path in the file ("instances[3].rotation: expected 4 numbers, found 3") and reads
/// as its default; whoever reads a whole file asks for the error at the end.

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

/// What a number may be.
struct Range {
  double least, most;
};

class StrictObject {
 public:
  using Problem = std::optional<std::string>;

  /// `value` may be anything; `path` names it in messages, "" is the whole file.
  StrictObject(const nlohmann::json& value, std::string path,
               std::span<const std::string_view> keys, Problem& problem);

  bool has(std::string_view key) const { return find(key) != nullptr; }

  /// The value as it is, or null where it is absent.
  const nlohmann::json* find(std::string_view key) const;

  /// A string, or nothing where it is absent or null.
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

  /// The members of an object whose keys are names that the file chooses; at least one.
  const nlohmann::json& members(std::string_view key) const;

  /// Notes that `key` is missing, where it is.
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

/// What JSON calls a value, for messages: "an array", "a string" ...
std::string kind_of(const nlohmann::json& value);

}  // namespace pelt::scenes
