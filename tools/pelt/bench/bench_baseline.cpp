#include "tools/pelt/bench/bench_baseline.hpp"

#include "asset/file_bytes.hpp"
#include "asset/json_object.hpp"
#include "asset/parsed_json.hpp"
#include "tools/pelt/output/text.hpp"

#include <nlohmann/json.hpp>

#include <array>

namespace pelt::tools::bench {
namespace {

using asset::FirstError;
using asset::JsonObject;

constexpr const char* kRemedy = "give a file written by pelt bench --json of this version";

std::string required_text(const JsonObject& object, const char* key) {
  std::string text = object.text(key);
  if (text.empty()) object.refuse(key, "is missing");
  return text;
}

/// Returns the one of several values that has the name.
template <typename T>
T one_of(const JsonObject& object, const char* key, std::initializer_list<T> values) {
  const std::string name = required_text(object, key);
  std::string names;
  for (const T value : values) {
    if (name == name_of(value)) return value;
    names += (names.empty() ? "must be " : " or ") + std::string(name_of(value));
  }
  object.refuse(key, names);
  return *values.begin();
}

/// Reads a time, which must be positive because it is a divisor.
double positive(const JsonObject& object, const char* key) {
  const double number = static_cast<double>(object.number(key, 0));
  if (!(number > 0)) object.refuse(key, "must be a number above 0");
  return number;
}

std::uint64_t hash(const JsonObject& object) {
  std::uint64_t value = 0;
  if (!output::parse_hex16(object.text("hash"), value))
    object.refuse("hash", "must be 16 hexadecimal digits");
  return value;
}

/// The name of a member, or the name that it had in version 0.1.
const char* known_key(const JsonObject& object, const char* key, const char* former) {
  return !object.has(key) && object.has(former) ? former : key;
}

Figures read_figures(const JsonObject& object) {
  Figures figures;
  figures.method = required_text(object, known_key(object, "method", "engine"));
  figures.variant = {one_of(object, "query", {Question::all, Question::first}),
                     one_of(object, "cache", {Cache::hot, Cache::cold})};
  figures.asked = one_of(object, "asked", {Asked::pairs, Asked::crowd, Asked::self, Asked::none});
  figures.threads = static_cast<std::uint32_t>(object.count("threads"));
  figures.answer.hash = hash(object);
  figures.times.mean_us = positive(object, "mean_us");
  return figures;
}

SceneFigures read_scene(const JsonObject& object) {
  SceneFigures scene;
  scene.scene = required_text(object, "scene");
  scene.frames = object.count("frames");
  scene.time = one_of(object, "time", {Time::thread, Time::wall});
  for (const JsonObject& method : object.objects(known_key(object, "methods", "engines")))
    scene.figures.push_back(read_figures(method));
  return scene;
}

Machine read_machine(const JsonObject& object) {
  Machine machine;
  machine.cpu = required_text(object, "cpu");
  machine.compiler = required_text(object, "compiler");
  machine.build = required_text(object, "build");
  machine.instruction_set = required_text(object, known_key(object, "instruction_set", "target"));
  machine.cores = static_cast<unsigned>(object.count("cores"));
  return machine;
}

void require_format(const JsonObject& file) {
  if (file.text("format") != "pelt-bench") file.refuse("format", "must be pelt-bench");
  if (file.count("version") != 1) file.refuse("version", "must be 1");
  if (!file.has("scenes")) file.refuse("scenes", "is missing");
}

Error unusable(const std::string& path, const Error& error) {
  return {error.code, path + ": " + error.message + ": " + kRemedy};
}

}  // namespace

Result<Baseline> parse_baseline(const std::string& path, std::string_view text) {
  const Result<asset::ParsedJson> parsed = asset::parse_json(text);
  if (!parsed) return unusable(path, parsed.error());
  FirstError errors;
  const JsonObject file(**parsed, "", errors);
  require_format(file);
  Baseline baseline;
  baseline.path = path;
  baseline.machine = read_machine(file.object("machine"));
  for (const JsonObject& scene : file.objects("scenes"))
    baseline.scenes.push_back(read_scene(scene));
  if (errors.get()) return unusable(path, *errors.get());
  return baseline;
}

Result<Baseline> read_baseline(const std::string& path) {
  const auto bytes = asset::read_file(path);
  if (!bytes) return Error{bytes.error().code, bytes.error().message + ": " + kRemedy};
  return parse_baseline(path, {reinterpret_cast<const char*>(bytes->data()), bytes->size()});
}

}  // namespace pelt::tools::bench
