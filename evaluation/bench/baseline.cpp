#include "evaluation/bench/baseline.hpp"

#include "asset/file_bytes.hpp"
#include "asset/json_object.hpp"
#include "asset/parsed_json.hpp"
#include "text/format.hpp"

#include <algorithm>

namespace pelt::lab {
namespace {

using asset::JsonObject;
using tools::bench::Row;

std::string remedy(const FiguresFormat& format) {
  return std::string(": give a file written by ") + format.command + " of this version";
}

/// Names another kind of figures, which is easily confused.
void require_format(const JsonObject& file, const FiguresFormat& format) {
  const std::string name = file.text("format");
  const bool is_other = name != format.name && name.rfind(kFramesFormat.name, 0) == 0;
  if (name != format.name)
    file.refuse("format",
                std::string("must be ") + format.name + (is_other ? ", not " + name : ""));
  if (file.count("version") != 1) file.refuse("version", "must be 1");
  if (!file.has("scenes")) file.refuse("scenes", "is missing");
}

/// The name of a member, or the name that it had in version 0.1.
const char* known_key(const JsonObject& object, const char* key, const char* former) {
  return former && !object.has(key) && object.has(former) ? former : key;
}

std::string required_text(const JsonObject& object, const char* key) {
  std::string text = object.text(key);
  if (text.empty()) object.refuse(key, "is missing");
  return text;
}

std::string one_of(const JsonObject& object, const char* key,
                   const std::vector<const char*>& values) {
  const std::string name = required_text(object, key);
  std::string names;
  for (const char* value : values) {
    if (name == value) return name;
    names += (names.empty() ? "must be " : " or ") + std::string(value);
  }
  object.refuse(key, names);
  return name;
}

double positive(const JsonObject& object, const char* key) {
  const double number = static_cast<double>(object.number(key, 0));
  if (!(number > 0)) object.refuse(key, "must be a number above 0");
  return number;
}

std::string hash_in(const JsonObject& object, const char* key) {
  std::uint64_t value = 0;
  if (!text::parse_hex16(object.text(key), value))
    object.refuse(key, "must be 16 hexadecimal digits");
  return object.text(key);
}

Row read_value(const JsonObject& object, const char* key, const Field& field) {
  switch (field.kind) {
    case Field::Kind::text:
      return required_text(object, key);
    case Field::Kind::name:
      return one_of(object, key, field.names);
    case Field::Kind::count:
      return object.count(key);
    case Field::Kind::hash:
      return hash_in(object, key);
    case Field::Kind::time:
      return positive(object, key);
  }
  return {};
}

Row read_fields(const JsonObject& object, const std::vector<Field>& fields) {
  Row row;
  for (const Field& field : fields)
    row[field.name] = read_value(object, known_key(object, field.name, field.former), field);
  return row;
}

Row read_scene(const JsonObject& object, const FiguresFormat& format) {
  Row scene = read_fields(object, format.scene);
  scene["methods"] = Row::array();
  for (const JsonObject& method : object.objects(known_key(object, "methods", "engines")))
    scene["methods"].push_back(read_fields(method, format.method));
  return scene;
}

tools::bench::Machine read_machine(const JsonObject& object) {
  tools::bench::Machine machine;
  machine.cpu = required_text(object, "cpu");
  machine.compiler = required_text(object, "compiler");
  machine.build = required_text(object, "build");
  machine.instruction_set = required_text(object, known_key(object, "instruction_set", "target"));
  machine.cores = static_cast<unsigned>(object.count("cores"));
  return machine;
}

}  // namespace

const FiguresFormat kFramesFormat = {
    "pelt-bench",
    "pelt bench --json",
    {{"scene", Field::Kind::text},
     {"frames", Field::Kind::count},
     {"time", Field::Kind::name, {"thread", "wall"}}},
    {{"method", Field::Kind::text, {}, "engine"},
     {"query", Field::Kind::name, {"all", "first"}},
     {"cache", Field::Kind::name, {"hot", "cold"}},
     {"asked", Field::Kind::name, {"pairs", "crowd", "self", "none"}},
     {"threads", Field::Kind::count},
     {"hash", Field::Kind::hash},
     {"mean_us", Field::Kind::time}}};

const FiguresFormat kStepsFormat = {
    "pelt-bench-moving",
    "pelt-lab bench --moving --json",
    {{"scene", Field::Kind::text}, {"steps", Field::Kind::count}},
    {{"method", Field::Kind::text},
     {"query", Field::Kind::name, {"collide", "pairs", "times", "first", "touch"}},
     {"hash", Field::Kind::hash},
     {"mean_us", Field::Kind::time}}};

Result<Baseline> parse_baseline(const std::string& path, std::string_view text,
                                const FiguresFormat& format) {
  const auto unusable = [&](const Error& error) {
    return Error{error.code, path + ": " + error.message + remedy(format)};
  };
  const Result<asset::ParsedJson> parsed = asset::parse_json(text);
  if (!parsed) return unusable(parsed.error());
  asset::FirstError errors;
  const JsonObject file(**parsed, "", errors);
  require_format(file, format);
  Baseline baseline = {path, read_machine(file.object("machine")), {}};
  for (const JsonObject& scene : file.objects("scenes"))
    baseline.scenes.push_back(read_scene(scene, format));
  if (errors.get()) return unusable(*errors.get());
  return baseline;
}

Result<Baseline> read_baseline(const std::string& path, const FiguresFormat& format) {
  const auto bytes = asset::read_file(path);
  if (!bytes) return Error{bytes.error().code, bytes.error().message + remedy(format)};
  return parse_baseline(
      path, std::string_view(reinterpret_cast<const char*>(bytes->data()), bytes->size()), format);
}

}  // namespace pelt::lab
