#include "tools/pelt/bench/figures_reader.hpp"

#include "asset/file_bytes.hpp"
#include "asset/parsed_json.hpp"
#include "tools/pelt/output/text.hpp"

#include <nlohmann/json.hpp>

namespace pelt::tools::bench {
namespace {

std::string remedy(const FiguresFormat& format) {
  return std::string(": give a file written by ") + format.command + " of this version";
}

Error unusable(const std::string& path, const Error& error, const FiguresFormat& format) {
  return {error.code, path + ": " + error.message + remedy(format)};
}

/// Names another kind of figures, which is easily confused.
void require_format(const asset::JsonObject& file, const FiguresFormat& format) {
  const std::string name = file.text("format");
  const bool is_other = name != format.name && name.rfind(kSceneFormat.name, 0) == 0;
  if (name != format.name)
    file.refuse("format",
                std::string("must be ") + format.name + (is_other ? ", not " + name : ""));
  if (file.count("version") != 1) file.refuse("version", "must be 1");
  if (!file.has("scenes")) file.refuse("scenes", "is missing");
}

}  // namespace

Result<void> parse_figures(const std::string& path, std::string_view text,
                           const FiguresFormat& format,
                           const std::function<void(const asset::JsonObject&)>& read) {
  const Result<asset::ParsedJson> parsed = asset::parse_json(text);
  if (!parsed) return unusable(path, parsed.error(), format);
  asset::FirstError errors;
  const asset::JsonObject file(**parsed, "", errors);
  require_format(file, format);
  read(file);
  if (errors.get()) return unusable(path, *errors.get(), format);
  return {};
}

Result<std::string> read_figures(const std::string& path, const FiguresFormat& format) {
  const auto bytes = asset::read_file(path);
  if (!bytes) return Error{bytes.error().code, bytes.error().message + remedy(format)};
  return std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size());
}

Machine read_machine(const asset::JsonObject& object) {
  Machine machine;
  machine.cpu = required_text(object, "cpu");
  machine.compiler = required_text(object, "compiler");
  machine.build = required_text(object, "build");
  machine.instruction_set = required_text(object, known_key(object, "instruction_set", "target"));
  machine.cores = static_cast<unsigned>(object.count("cores"));
  return machine;
}

const char* known_key(const asset::JsonObject& object, const char* key, const char* former) {
  return !object.has(key) && object.has(former) ? former : key;
}

std::string required_text(const asset::JsonObject& object, const char* key) {
  std::string text = object.text(key);
  if (text.empty()) object.refuse(key, "is missing");
  return text;
}

double positive(const asset::JsonObject& object, const char* key) {
  const double number = static_cast<double>(object.number(key, 0));
  if (!(number > 0)) object.refuse(key, "must be a number above 0");
  return number;
}

std::uint64_t hash_in(const asset::JsonObject& object) {
  std::uint64_t value = 0;
  if (!output::parse_hex16(object.text("hash"), value))
    object.refuse("hash", "must be 16 hexadecimal digits");
  return value;
}

}  // namespace pelt::tools::bench
