#pragma once

/// Reads figures that `pelt bench --json` has written, for comparison with a later run. Errors name
/// the file, the value and the remedy.

#include <pelt/result.hpp>

#include "asset/json_object.hpp"
#include "tools/pelt/bench/machine.hpp"

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace pelt::tools::bench {

/// A kind of figures.
struct FiguresFormat {
  const char* name;     ///< the value of `format`
  const char* command;  ///< which writes it
};

inline constexpr FiguresFormat kSceneFormat = {"pelt-bench", "pelt bench --json"};
inline constexpr FiguresFormat kMovingFormat = {"pelt-bench-moving", "pelt bench --moving --json"};

/// Checks the format of a text and calls `read` with its content. `path` is for messages.
Result<void> parse_figures(const std::string& path, std::string_view text,
                           const FiguresFormat& format,
                           const std::function<void(const asset::JsonObject&)>& read);

/// Returns the text of a file.
Result<std::string> read_figures(const std::string& path, const FiguresFormat& format);

Machine read_machine(const asset::JsonObject& object);

/// Figures of an earlier run.
template <typename AnyScene>
struct BaselineOf {
  std::string path;  ///< as given by the user
  Machine machine;
  std::vector<AnyScene> scenes;  ///< only compared values: names, counts, hashes, means
};

/// `path` is for messages. `read_scene(object)` reads the figures of one scene.
template <typename AnyScene>
Result<BaselineOf<AnyScene>> parse_baseline(const std::string& path, std::string_view text,
                                            const FiguresFormat& format,
                                            AnyScene (*read_scene)(const asset::JsonObject&)) {
  BaselineOf<AnyScene> baseline;
  baseline.path = path;
  const auto parsed = parse_figures(path, text, format, [&](const asset::JsonObject& file) {
    baseline.machine = read_machine(file.object("machine"));
    for (const asset::JsonObject& scene : file.objects("scenes"))
      baseline.scenes.push_back(read_scene(scene));
  });
  if (!parsed) return parsed.error();
  return baseline;
}

/// The name of a member, or the name that it had in version 0.1.
const char* known_key(const asset::JsonObject& object, const char* key, const char* former);

std::string required_text(const asset::JsonObject& object, const char* key);

/// Reads a time, which must be positive because it is a divisor.
double positive(const asset::JsonObject& object, const char* key);

std::uint64_t hash_in(const asset::JsonObject& object);

/// Returns the one of several values that has the name.
template <typename Values>
auto one_of(const asset::JsonObject& object, const char* key, const Values& values) {
  const std::string name = required_text(object, key);
  std::string names;
  for (const auto value : values) {
    if (name == name_of(value)) return value;
    names += (names.empty() ? "must be " : " or ") + std::string(name_of(value));
  }
  object.refuse(key, names);
  return *std::begin(values);
}

template <typename T>
T one_of(const asset::JsonObject& object, const char* key, std::initializer_list<T> values) {
  return one_of<std::initializer_list<T>>(object, key, values);
}

}  // namespace pelt::tools::bench
