#include "tools/pelt/shard/shard_file.hpp"

#include "asset/message.hpp"
#include "asset/parsed_json.hpp"
#include "base/workers.hpp"
#include "scenes/takes.hpp"
#include "tools/pelt/check/ordered_work.hpp"
#include "tools/pelt/list/scene_entry.hpp"
#include "tools/pelt/output/json_text.hpp"
#include "tools/pelt/output/text.hpp"
#include "tools/pelt/shard/answer_text.hpp"

#include <algorithm>
#include <atomic>
#include <fstream>
#include <optional>
#include <utility>

namespace pelt::tools::shard {
namespace {

using list::read_line;
using nlohmann::json;

void add_line(const std::string& line, detail::Fnv1a64& hash) {
  hash.add_bytes(std::as_bytes(std::span(line)));
  hash.add_byte('\n');
}

nlohmann::ordered_json last_line(std::size_t lines, const detail::Fnv1a64& hash) {
  return {{"lines", lines}, {"hash", output::hex16(hash.value())}};
}

Error unreadable(const std::string& path) {
  return {ErrorCode::unreadable_file, path + ": cannot be read: check its name"};
}

Error incomplete(const std::string& path, const Shard& shard, const char* problem) {
  return asset::malformed(path + ": " + problem + ": write shard " + std::to_string(shard.index) +
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
  if (!header) return asset::prefixed(path, header.error());
  detail::Fnv1a64 hash;
  std::size_t lines = 0;
  std::string next;
  for (; read_line(in, next); ++lines) {
    add_line(line, hash);
    std::swap(line, next);
  }
  const bool is_whole =
      next.empty() && lines > 0 && line == output::json_text(last_line(lines - 1, hash));
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
    return asset::malformed(other.path + ": is one of " + std::to_string(b.count) +
                            " shards, but " + first.path + " is one of " + std::to_string(a.count) +
                            ": give shards of one check");
  if (first.header.question != other.header.question)
    return asset::malformed(other.path + ": is from another check than " + first.path + " (" +
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
      return asset::malformed(shards[i].path + ": is the same shard as " + shards[i - 1].path +
                              ": give one of the two");
    if (index != next) break;
  }
  if (next > count) return {};
  const std::string name = std::to_string(next) + "/" + std::to_string(count);
  return Error{
      ErrorCode::invalid_argument,
      "shard " + name + " is missing: write it with --shard " + name + ", or give its file, too"};
}

/// The scene and the frames of all answers of a check.
struct ExpectedFrames {
  const scene::StagedScene& staged;
  std::vector<std::uint32_t> frames;
  bool has_steps;

  Expected at(std::size_t index) const {
    return {staged, frames[index], has_steps ? step_from(index) : std::nullopt};
  }

 private:
  /// The frame that the step to a frame starts from, if any.
  std::optional<std::uint32_t> step_from(std::size_t index) const {
    if (index == 0) return std::nullopt;
    const std::uint32_t from = frames[index - 1];
    if (take_of(from) != take_of(frames[index])) return std::nullopt;
    return from;
  }

  std::uint32_t take_of(std::uint32_t frame) const {
    return scenes::take_index(staged.scene, frame);
  }
};

/// The answers of the frames of a shard.
class ShardAnswers {
 public:
  struct Item {
    AnswerLines lines;
    bool is_there = false;  // otherwise the file has ended
    check::FrameAnswer answer;
  };

  ShardAnswers(const std::string& path, const Shard& shard, std::istream& in,
               const ExpectedFrames& expected)
      : path_(path), shard_(shard), in_(in), expected_(expected) {}

  /// Passes the answers to `use`, in order.
  Result<void> replay(std::uint32_t threads, const check::UseAnswer& use) const {
    const std::size_t begin = shard_.begin_of(expected_.frames.size());
    const std::size_t end = shard_.end_of(expected_.frames.size());
    const auto read_next = [this](Item& next) { next.is_there = read_lines(in_, next.lines); };
    const auto interpret = [&](std::uint32_t, std::size_t index, Item& item) {
      return this->interpret(expected_.at(begin + index), item);
    };
    const auto pass_on = [&](const Item& item) { return use(item.answer); };
    check::OrderedWork<Item> work(end - begin, threads, interpret, pass_on, read_next);
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
  const ExpectedFrames& expected_;
};

/// Nullopt if the file has no whole answer of a scene at this place.
std::optional<list::SceneAnswer> read_scene(std::istream& in) {
  list::SceneAnswer answer;
  std::string line;
  if (!read_line(in, line)) return std::nullopt;
  Result<list::SceneEntry> entry = list::read_entry(line);
  if (!entry) return std::nullopt;
  const auto lines = list::read_lines_of(*entry, in);
  if (!lines) return std::nullopt;
  answer.entry = std::move(*entry);
  answer.text = line + '\n';
  for (const std::string& one : *lines) answer.text += one + '\n';
  return answer;
}

}  // namespace

ShardWriter::ShardWriter(std::ostream& out, const nlohmann::ordered_json& header) : out_(out) {
  write(output::json_text(header) + '\n');
}

void ShardWriter::add(const check::FrameAnswer& answer) { write(answer_text(answer)); }

void ShardWriter::add(const list::SceneAnswer& answer) { write(answer.text); }

/// The first line is not counted.
void ShardWriter::finish() { out_ << output::json_text(last_line(lines_ - 1, hash_)) << '\n'; }

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
  shards.arguments_ = opened[0].header.arguments;
  shards.inputs_ = opened[0].header.question["inputs"];
  for (Opened& shard : opened) shards.paths_.push_back(std::move(shard.path));
  return shards;
}

Result<void> Shards::check_inputs(const scenes::Scene& scene) const {
  const Result<json> inputs = inputs_of(arguments_.scene, scene);
  if (!inputs) return inputs.error();
  if (*inputs == inputs_) return {};
  std::string name = scene.name;
  for (std::size_t i = 0; i < std::min(inputs->size(), inputs_.size()); ++i)
    if ((*inputs)[i] != inputs_[i]) name = (*inputs)[i].value("path", name);
  return asset::malformed(name +
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

Result<void> Shards::replay(const scene::StagedScene& staged, const check::CheckSettings& settings,
                            const check::UseAnswer& use) const {
  const ExpectedFrames expected = {staged, settings.frames.frames(), settings.substeps.has_value()};
  const std::uint32_t threads = detail::Workers::count_or_available(settings.threads);
  return each_shard([&](const std::string& path, const Shard& shard, std::istream& in) {
    return ShardAnswers(path, shard, in, expected).replay(threads, use);
  });
}

Result<void> Shards::replay_scenes(const list::UseScene& use) const {
  return each_shard(
      [&](const std::string& path, const Shard& shard, std::istream& in) -> Result<void> {
        for (std::size_t i = shard.begin_of(scenes()); i < shard.end_of(scenes()); ++i) {
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
