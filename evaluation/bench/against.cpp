#include "evaluation/bench/against.hpp"

#include "asset/file_bytes.hpp"
#include "asset/json_object.hpp"
#include "asset/parsed_json.hpp"
#include "text/format.hpp"
#include "text/printable.hpp"

#include <algorithm>
#include <iomanip>
#include <set>

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

namespace {

using text::counted;
using tools::bench::find_row;
using tools::bench::Yardstick;

constexpr int kKey = 13, kNumber = 10, kMark = 7;

std::span<const Row> methods_of(const Row& scene) {
  return scene["methods"].get_ref<const Row::array_t&>();
}

std::string text_in(const Row& row, const char* name) { return row[name].get<std::string>(); }

std::string in_words(const Row& ratio) {
  return ratio.is_null() ? "-" : text::fixed(ratio.get<double>(), 2);
}

/// The query and the method of each row, in words.
std::set<std::string> names_in(const Row& scene) {
  std::set<std::string> names;
  for (const Row& row : methods_of(scene)) {
    std::string query = "query " + text_in(row, "query"), method = text_in(row, "method");
    if (row.contains("cache")) query += " with " + text_in(row, "cache") + " caches";
    const bool is_crowd = row.contains("asked") && row["asked"] == "crowd";
    names.insert(query);
    names.insert(is_crowd ? "crowd of " + method + " on " +
                                counted(row["threads"].get<std::uint64_t>(), "thread")
                          : "method " + method);
  }
  return names;
}

/// Another hash of the same query in `then`, or null.
const Row* other_hash(const Row& then, const Row& now) {
  for (const Row& row : methods_of(then))
    if (row["query"] == now["query"] && row["hash"] != now["hash"]) return &row["hash"];
  return nullptr;
}

/// Compares scenes with those of a baseline, and prints the result.
class Comparer {
 public:
  Comparer(const ComparedFigures& compared, const Baseline& baseline, std::uint32_t margin_percent,
           std::ostream& out)
      : compared_(compared),
        baseline_(baseline),
        path_(text::printable(baseline.path)),
        count_(compared.unit + std::string("s")),
        limit_(1 + margin_percent / 100.0),
        out_(out) {}

  void compare(const Row& now) {
    const Row* then = find_row(baseline_.scenes, {{"scene", now["scene"]}});
    const auto count = now[count_].get<std::uint64_t>();
    out_ << '\n' << text::printable(text_in(now, "scene")) << ": ";
    if (!then)
      out_ << path_ << " does not contain this scene\n";
    else if ((*then)[count_] != count)
      out_ << counted(count, compared_.unit) << ", not the "
           << text::with_commas((*then)[count_].get<std::uint64_t>()) << " of " << path_
           << ": not compared\n";
    else
      compare(*then, now);
  }

  const Comparison& result() const { return result_; }

 private:
  void compare(const Row& then, const Row& now) {
    out_ << counted(now[count_].get<std::uint64_t>(), compared_.unit);
    if (now.contains("time")) {
      out_ << ", " << text_in(now, "time") << " time";
      if (then["time"] != now["time"]) out_ << ", " << text_in(then, "time") << " time then";
    }
    out_ << '\n';
    print_lacking(then, now);
    const std::set<std::string> different = print_different_answers(then, now);
    const std::vector<Yardstick> yardsticks = yardsticks_of(now);
    print_head(yardsticks);
    const auto& left_out = compared_.left_out;
    for (const Row& row : methods_of(now))
      if (different.count(text_in(row, "query")) == 0 &&
          std::find(left_out.begin(), left_out.end(), row["method"]) == left_out.end())
        print_row(then, now, row, yardsticks);
  }

  void print_lacking(const Row& then, const Row& now) {
    const std::set<std::string> known = names_in(then);
    for (const std::string& name : names_in(now))
      if (known.count(name) == 0) out_ << path_ << " has no " << text::printable(name) << '\n';
  }

  /// Figures for different answers cannot be compared. Returns their queries.
  std::set<std::string> print_different_answers(const Row& then, const Row& now) {
    std::set<std::string> different;
    for (const Row& row : methods_of(now)) {
      const Row* hash = other_hash(then, row);
      if (!hash || !different.insert(text_in(row, "query")).second) continue;
      out_ << "query " << text_in(row, "query") << ": different answers: hash "
           << hash->get<std::string>() << " then, " << text_in(row, "hash")
           << " now: not compared\n";
      ++result_.different_answers;
    }
    return different;
  }

  /// The rows that the tables of times show.
  std::vector<Yardstick> yardsticks_of(const Row& scene) const {
    std::vector<Yardstick> shown;
    for (const Yardstick& yardstick : compared_.yardsticks)
      if (find_row(methods_of(scene), {{"method", yardstick.method}}) ||
          (yardstick.is_for_pairs && !scene.contains("sequence")))
        shown.push_back(yardstick);
    return shown;
  }

  void print_head(std::span<const Yardstick> yardsticks) {
    out_ << std::string(kKey * compared_.keys.size(), ' ');
    for (const Yardstick& yardstick : yardsticks)
      out_ << std::setw(3 * kNumber) << yardstick.title << std::string(kMark, ' ');
    out_ << '\n';
    for (const char* key : compared_.keys) print_key(key);
    for (std::size_t i = 0; i < yardsticks.size(); ++i)
      out_ << std::setw(kNumber) << "then" << std::setw(kNumber) << "now" << std::setw(kNumber)
           << "now/then" << std::string(kMark, ' ');
    out_ << '\n';
  }

  void print_key(const std::string& text) {
    out_ << std::left << std::setw(kKey) << text << std::right;
  }

  void print_row(const Row& then, const Row& now, const Row& row,
                 std::span<const Yardstick> yardsticks) {
    Row like;
    for (const char* key : compared_.keys) {
      like[key] = row[key];
      print_key(row[key].is_string() ? text_in(row, key) : row[key].dump());
    }
    const Row* before = find_row(methods_of(then), like);
    for (const Yardstick& yardstick : yardsticks) {
      const bool is_itself = row["method"] == yardstick.method &&
                             (!yardstick.query || row["query"] == yardstick.query);
      const auto ratio = [&](const Row& scene, const Row* of) {
        return of && !is_itself ? ratio_to(yardstick, methods_of(scene), *of) : Row();
      };
      print_ratio(ratio(then, before), ratio(now, &row), yardstick.is_cost);
    }
    out_ << '\n';
  }

  void print_ratio(const Row& then, const Row& now, bool is_cost) {
    Row change;
    if (!then.is_null() && !now.is_null()) change = now.get<double>() / then.get<double>();
    const bool is_worse =
        !change.is_null() && (is_cost ? change.get<double>() : 1 / change.get<double>()) > limit_;
    for (const Row& number : {then, now, change}) out_ << std::setw(kNumber) << in_words(number);
    out_ << std::left << std::setw(kMark) << (is_worse ? " worse" : "") << std::right;
    result_.ratios += !change.is_null();
    result_.worse += is_worse;
  }

  const ComparedFigures& compared_;
  const Baseline& baseline_;
  std::string path_, count_;
  double limit_;
  std::ostream& out_;
  Comparison result_;
};

}  // namespace

Comparison print_comparison(const ComparedFigures& compared, const Baseline& then,
                            std::span<const Row> now, std::uint32_t margin_percent,
                            std::ostream& out) {
  Comparer comparer(compared, then, margin_percent, out);
  out << "against " << text::printable(then.path) << ": "
      << text::printable(tools::bench::in_words(then.machine)) << '\n';
  for (const Row& scene : now) comparer.compare(scene);
  const Comparison& result = comparer.result();
  out << '\n'
      << result.worse << " of " << counted(result.ratios, "ratio") << " worse by more than "
      << margin_percent << " %\n";
  return result;
}

}  // namespace pelt::lab
