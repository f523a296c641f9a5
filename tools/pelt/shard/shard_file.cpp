#include "tools/pelt/shard/shard_file.hpp"

#include <pelt/version.hpp>

#include "asset/file_bytes.hpp"
#include "asset/parsed_json.hpp"
#include "base/workers.hpp"
#include "text/format.hpp"
#include "text/json_text.hpp"
#include "text/message.hpp"
#include "tools/pelt/check/ordered_work.hpp"
#include "tools/pelt/list/entry.hpp"
#include "tools/pelt/scene/json_lines.hpp"
#include "tools/pelt/shard/answer_text.hpp"

#include <algorithm>
#include <atomic>
#include <charconv>
#include <fstream>
#include <optional>
#include <utility>

namespace pelt::tools::shard {
namespace {

using list::read_line;
using nlohmann::json;

constexpr std::uint32_t kVersion = 2;

/// 0 for anything but a whole number from 1 to `most`.
std::uint32_t parse_number(std::string_view text, std::uint32_t most) {
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && value <= most ? value : 0;
}

bool read_shard(const json& value, Shard& shard) {
  if (!value.is_array() || value.size() != 2) return false;
  for (const json& number : value)
    if (!number.is_number_unsigned() || number.get<std::uint64_t>() > kMostShards) return false;
  shard = {value[0].get<std::uint32_t>(), value[1].get<std::uint32_t>()};
  return shard.index >= 1 && shard.index <= shard.count;
}

/// "path" and "hash" of a file.
Result<nlohmann::ordered_json> input_json(const std::string& path) {
  const auto bytes = asset::read_file(path);
  if (!bytes) return bytes.error();
  detail::Fnv1a64 hash;
  hash.add_bytes(*bytes);
  return nlohmann::ordered_json{{"path", path}, {"hash", text::hex16(hash.value())}};
}

/// Whether the first input is a list with a number of scenes.
bool has_list(const json& inputs) {
  if (inputs.empty() || !inputs[0].is_object()) return false;
  const json scenes = inputs[0].value("scenes", json());
  return scenes.is_number_unsigned() && scenes.get<std::uint64_t>() <= list::kMostScenes;
}

Error not_a_shard() {
  return text::malformed("not a file of a shard: give files that pelt check --shard wrote");
}

struct ShardHeader {
  Shard shard;
  check::CheckOptions options;  ///< see check::arguments_json
  nlohmann::json question;      ///< the arguments and the hashes of the inputs, to be compared
};

/// Error messages have no place.
Result<ShardHeader> read_header(const std::string& line) {
  const Result<asset::ParsedJson> parsed = asset::parse_json(line);
  if (!parsed || !(*parsed)->is_object() || (*parsed)->value("format", json()) != "pelt-shard")
    return not_a_shard();
  const json& object = **parsed;
  const json version = object.value("version", json()), pelt = object.value("pelt", json());
  const json arguments = object.value("arguments", json());
  if (version != kVersion || pelt != PELT_VERSION || !check::has_known_options(arguments))
    return text::unsupported("was written by another version of pelt (" + pelt.dump() +
                             "): write and merge all shards with one version");
  ShardHeader header;
  if (!read_shard(object.value("shard", json()), header.shard) ||
      !check::read_options(arguments, header.options) || !object.value("inputs", json()).is_array())
    return text::malformed("the first line is damaged: write this shard again");
  if (!header.options.scenes.empty() && !has_list(object["inputs"]))
    return text::malformed("the first line is damaged: write this shard again");
  header.question = {{"arguments", arguments}, {"inputs", object["inputs"]}};
  return header;
}

void add_line(const std::string& line, detail::Fnv1a64& hash) {
  hash.add_bytes(std::as_bytes(std::span(line)));
  hash.add_byte('\n');
}

nlohmann::ordered_json last_line(std::size_t lines, const detail::Fnv1a64& hash) {
  return {{"lines", lines}, {"hash", text::hex16(hash.value())}};
}

Error unreadable(const std::string& path) {
  return {ErrorCode::unreadable_file, path + ": cannot be read: check its name"};
}

Error incomplete(const std::string& path, const Shard& shard, const char* problem) {
  return text::malformed(path + ": " + problem + ": write shard " + std::to_string(shard.index) +
                         "/" + std::to_string(shard.count) + " again");
}

/// A file that is complete.
struct Opened {
  std::string path;
  ShardHeader header;
};

Result<Opened> open_shard(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::string line;
  if (!in.is_open() || (in.peek(), in.bad())) return unreadable(path);
  if (!read_line(in, line)) line.clear();
  Result<ShardHeader> header = read_header(line);
  if (!header) return text::prefixed(path, header.error());
  detail::Fnv1a64 hash;
  std::size_t lines = 0;
  std::string next;
  for (; read_line(in, next); ++lines) {
    add_line(line, hash);
    std::swap(line, next);
  }
  const bool is_whole =
      next.empty() && lines > 0 && line == text::json_text(last_line(lines - 1, hash));
  if (!is_whole) return incomplete(path, header->shard, "is incomplete or was changed");
  return Opened{path, std::move(*header)};
}

/// Opens files on several threads, in order up to the first that cannot be opened.
std::vector<std::optional<Result<Opened>>> open_shards(std::span<const std::string> paths,
                                                       std::uint32_t threads) {
  std::vector<std::optional<Result<Opened>>> opened(paths.size());
  const auto count = static_cast<std::uint32_t>(
      std::clamp<std::size_t>(paths.size(), 1, detail::Workers::count_or_available(threads)));
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> has_failed = false;
  detail::Workers workers;
  workers.run(count, [&](std::uint32_t) {
    for (std::size_t i = next++; i < paths.size() && !has_failed; i = next++) {
      opened[i] = open_shard(paths[i]);
      if (!*opened[i]) has_failed = true;
    }
  });
  return opened;
}

/// "frames" if the option --frames differs.
std::string difference(const json& a, const json& b) {
  for (const auto& [name, value] : a["arguments"].items())
    if (b["arguments"][name] != value) return "its " + name + " differs";
  return "its input files differ";
}

Result<void> compare(const Opened& first, const Opened& other) {
  const Shard &a = first.header.shard, &b = other.header.shard;
  if (a.count != b.count)
    return text::malformed(other.path + ": is one of " + std::to_string(b.count) + " shards, but " +
                           first.path + " is one of " + std::to_string(a.count) +
                           ": give shards of one check");
  if (first.header.question != other.header.question)
    return text::malformed(other.path + ": is from another check than " + first.path + " (" +
                           difference(first.header.question, other.header.question) +
                           "): give shards of one check");
  return {};
}

/// Precondition: sorted by index, all of one check.
Result<void> check_indices(std::span<const Opened> shards) {
  const std::uint32_t count = shards[0].header.shard.count;
  std::uint32_t next = 1;
  for (std::size_t i = 0; i < shards.size(); ++i, ++next) {
    const std::uint32_t index = shards[i].header.shard.index;
    if (i > 0 && index == shards[i - 1].header.shard.index)
      return text::malformed(shards[i].path + ": is the same shard as " + shards[i - 1].path +
                             ": give one of the two");
    if (index != next) break;
  }
  if (next > count) return {};
  const std::string name = std::to_string(next) + "/" + std::to_string(count);
  return Error{
      ErrorCode::invalid_argument,
      "shard " + name + " is missing: write it with --shard " + name + ", or give its file, too"};
}

/// The answers of the frames of a shard.
class ShardAnswers {
 public:
  struct Item {
    AnswerLines lines;
    bool is_there = false;  // otherwise the file has ended
    check::FrameAnswer answer;
  };

  ShardAnswers(const std::string& path, const Shard& shard, std::istream& in,
               const check::Stage& stage)
      : path_(path), shard_(shard), in_(in), stage_(stage) {}

  /// Passes the answers to `use`, in order.
  Result<void> replay(std::uint32_t threads, const check::UseAnswer& use) const {
    const check::Indices frames = shard_.of(stage_.frames.size());
    const auto read_next = [this](Item& next) { next.is_there = read_lines(in_, next.lines); };
    const auto interpret = [&](std::uint32_t, std::size_t index, Item& item) {
      return this->interpret({stage_.staged, stage_.frames[frames.begin + index],
                              stage_.step_from(frames.begin + index)},
                             item);
    };
    const auto pass_on = [&](const Item& item) { return use(item.answer); };
    check::OrderedWork<Item> work(frames.count(), threads, interpret, pass_on, read_next);
    if (const auto done = work.run(); !done) return done;
    std::string last, next;
    if (!read_line(in_, last) || read_line(in_, next))
      return incomplete(path_, shard_, "has more frames than the shard");
    return {};
  }

 private:
  Result<void> interpret(const Expected& expected, Item& item) const {
    if (!item.is_there) return bad_frame(expected, "is missing");
    Result<check::FrameAnswer> answer = read_answer(item.lines, expected);
    if (!answer) return bad_frame(expected, answer.error().message);
    item.answer = std::move(*answer);
    return {};
  }

  Error bad_frame(const Expected& expected, const std::string& problem) const {
    const std::string message = "frame " + std::to_string(expected.frame) + ": " + problem;
    return incomplete(path_, shard_, message.c_str());
  }

  const std::string& path_;
  const Shard& shard_;
  std::istream& in_;
  const check::Stage& stage_;
};

/// Nullopt if the file has no whole answer of a scene at this place.
std::optional<list::SceneAnswer> read_scene(std::istream& in) {
  list::SceneAnswer answer;
  std::string line;
  if (!read_line(in, line)) return std::nullopt;
  std::optional<list::SceneEntry> entry = list::read_entry(line);
  if (!entry) return std::nullopt;
  const auto lines = list::read_lines_of(*entry, in);
  if (!lines) return std::nullopt;
  answer.entry = std::move(*entry);
  answer.text = line + '\n';
  for (const std::string& one : *lines) answer.text += one + '\n';
  return answer;
}

}  // namespace

Result<Shard> parse_shard(const std::string& text) {
  const std::size_t slash = text.find('/');
  Shard shard = {0, 0};
  if (slash != std::string::npos) {
    shard.count = parse_number(std::string_view(text).substr(slash + 1), kMostShards);
    shard.index = parse_number(std::string_view(text).substr(0, slash), shard.count);
  }
  if (shard.index > 0) return shard;
  return text::bad_argument("--shard", text::quoted(text) + " is not a shard",
                            "give I/N, the I-th of N shards, from 1/N to N/N");
}

Result<json> inputs_of(const arguments::SceneArguments& arguments, const scenes::Scene& scene) {
  nlohmann::ordered_json inputs = nlohmann::ordered_json::array();
  if (arguments::asks_for_scene(arguments)) {
    auto input = input_json(arguments.inputs[0]);
    if (!input) return input.error();
    inputs.push_back(std::move(*input));
  }
  for (const scenes::Character& character : scene.characters)
    inputs.push_back({{"path", character.source}, {"hash", text::hex16(character.hash)}});
  return scene::as_json_holds(inputs);
}

Result<json> inputs_of(const list::ListPlan& plan) {
  nlohmann::ordered_json inputs = nlohmann::ordered_json::array();
  for (const std::string& path : {plan.options.scenes, plan.options.baseline}) {
    if (path.empty()) continue;
    auto input = input_json(path);
    if (!input) return input.error();
    inputs.push_back(std::move(*input));
  }
  inputs[0]["scenes"] = plan.scenes.size();
  return scene::as_json_holds(inputs);
}

nlohmann::ordered_json header_json(const Shard& shard, const check::CheckOptions& options,
                                   const json& inputs) {
  return {{"format", "pelt-shard"},
          {"version", kVersion},
          {"pelt", PELT_VERSION},
          {"shard", {shard.index, shard.count}},
          {"arguments", check::arguments_json(options)},
          {"inputs", inputs}};
}

ShardWriter::ShardWriter(std::ostream& out, const nlohmann::ordered_json& header) : out_(out) {
  write(text::json_text(header) + '\n');
}

void ShardWriter::add(const check::FrameAnswer& answer) { write(answer_text(answer)); }

void ShardWriter::add(const list::SceneAnswer& answer) { write(answer.text); }

/// The first line is not counted.
void ShardWriter::finish() { out_ << text::json_text(last_line(lines_ - 1, hash_)) << '\n'; }

void ShardWriter::write(const std::string& lines) {
  hash_.add_bytes(std::as_bytes(std::span(lines)));
  lines_ += static_cast<std::size_t>(std::count(lines.begin(), lines.end(), '\n'));
  out_ << lines;
}

Result<Shards> Shards::open(std::span<const std::string> paths, std::uint32_t threads) {
  std::vector<Opened> opened;
  for (std::optional<Result<Opened>>& shard : open_shards(paths, threads)) {
    if (!*shard) return shard->error();
    opened.push_back(std::move(**shard));
    if (const auto same = compare(opened[0], opened.back()); !same) return same.error();
  }
  std::stable_sort(opened.begin(), opened.end(), [](const Opened& a, const Opened& b) {
    return a.header.shard.index < b.header.shard.index;
  });
  if (const auto complete = check_indices(opened); !complete) return complete.error();
  Shards shards;
  shards.options_ = opened[0].header.options;
  shards.inputs_ = opened[0].header.question["inputs"];
  for (Opened& shard : opened) shards.paths_.push_back(std::move(shard.path));
  return shards;
}

Result<void> Shards::check_inputs(const scenes::Scene& scene) const {
  const Result<json> inputs = inputs_of(options_.scene, scene);
  if (!inputs) return inputs.error();
  if (*inputs == inputs_) return {};
  std::string name = scene.name;
  for (std::size_t i = 0; i < std::min(inputs->size(), inputs_.size()); ++i)
    if ((*inputs)[i] != inputs_[i]) name = (*inputs)[i].value("path", name);
  return text::malformed(name +
                         ": has changed since the shards were written: write all shards "
                         "again");
}

Result<void> Shards::each_shard(const ReadShard& read) const {
  const auto count = static_cast<std::uint32_t>(paths_.size());
  for (std::uint32_t s = 0; s < count; ++s) {
    std::ifstream in(paths_[s], std::ios::binary);
    std::string header;
    read_line(in, header);
    if (const auto done = read(paths_[s], {s + 1, count}, in); !done) return done;
  }
  return {};
}

Result<void> Shards::replay(const check::Stage& stage, const check::UseAnswer& use) const {
  const std::uint32_t threads =
      detail::Workers::count_or_available(stage.settings.options.threads.value_or(0));
  return each_shard([&](const std::string& path, const Shard& shard, std::istream& in) {
    return ShardAnswers(path, shard, in, stage).replay(threads, use);
  });
}

Result<void> Shards::replay_scenes(const list::UseScene& use) const {
  return each_shard(
      [&](const std::string& path, const Shard& shard, std::istream& in) -> Result<void> {
        for (std::size_t i = shard.of(scenes()).count(); i > 0; --i) {
          const std::optional<list::SceneAnswer> answer = read_scene(in);
          if (!answer) return incomplete(path, shard, "lacks a scene");
          if (const auto used = use(*answer); !used) return used;
        }
        std::string last, next;
        if (!read_line(in, last)) return incomplete(path, shard, "lacks a line of a scene");
        if (read_line(in, next)) return incomplete(path, shard, "has more scenes than the shard");
        return {};
      });
}

}  // namespace pelt::tools::shard
