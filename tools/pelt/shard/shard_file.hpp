#pragma once

/// Files of shards: a header, three lines per frame or the lines of each scene, and a last line
/// that shows that the file is complete. docs/pelt.1 describes the keys.

#include "base/hash.hpp"
#include "tools/pelt/check/frame_query.hpp"
#include "tools/pelt/list/list.hpp"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <ostream>
#include <span>
#include <string>
#include <vector>

namespace pelt::tools::shard {

/// The share of a check's frames, or of the scenes of a list, that one process queries: the I-th of
/// N runs of consecutive ones, of nearly equal length.
struct Shard {
  std::uint32_t index = 1, count = 1;  ///< index from 1 to count

  /// The indices of its frames or scenes, of this number.
  check::Indices of(std::size_t number) const {
    return {share(number, index - 1), share(number, index)};
  }

 private:
  std::size_t share(std::uint64_t number, std::uint64_t shards) const {
    return static_cast<std::size_t>(number * shards / count);
  }
};

inline constexpr std::uint32_t kMostShards = 1'000'000;

/// Parses "I/N". The option is --shard.
Result<Shard> parse_shard(const std::string& text);

/// The hashes of the scene's file, if it has one, and of its models.
Result<nlohmann::json> inputs_of(const arguments::SceneArguments& arguments,
                                 const scenes::Scene& scene);

/// The hash of the list, with its number of scenes, and that of the baseline, if there is one.
Result<nlohmann::json> inputs_of(const list::ListPlan& plan);

nlohmann::ordered_json header_json(const Shard& shard, const check::CheckOptions& options,
                                   const nlohmann::json& inputs);

class ShardWriter {
 public:
  /// Writes the header. `out` must outlive the writer.
  ShardWriter(std::ostream& out, const nlohmann::ordered_json& header);

  void add(const check::FrameAnswer& answer);
  void add(const list::SceneAnswer& answer);

  /// Writes the last line.
  void finish();

 private:
  void write(const std::string& lines);

  std::ostream& out_;
  detail::Fnv1a64 hash_;
  std::size_t lines_ = 0;
};

/// All shards of one check of a scene or of a list.
class Shards {
 public:
  /// Opens files in any order, and reads each of them once, on `threads` threads, or one per core
  /// if 0. Returns an error that names the file or the shard: for files that are damaged or
  /// incomplete, and for shards that are missing, given twice, or from different checks.
  static Result<Shards> open(std::span<const std::string> paths, std::uint32_t threads);

  /// The options of the check, without those of its outputs and its verdict.
  const check::CheckOptions& options() const { return options_; }

  /// Returns an error if the inputs are no longer those of the shards.
  Result<void> check_inputs(const scenes::Scene& scene) const;

  /// Passes the answers of all frames to `use`, in order. Reads them on the threads of the
  /// settings, and keeps at most four answers per thread in memory. Error messages name the file.
  Result<void> replay(const check::Stage& stage, const check::UseAnswer& use) const;

  bool is_of_list() const { return !options_.scenes.empty(); }

  /// The number of scenes of the list. Precondition: is_of_list().
  std::size_t scenes() const { return inputs_[0]["scenes"].get<std::size_t>(); }

  /// Passes the answers of all scenes to `use`, in order. Keeps one in memory. Precondition:
  /// is_of_list().
  Result<void> replay_scenes(const list::UseScene& use) const;

 private:
  using ReadShard =
      std::function<Result<void>(const std::string& path, const Shard& shard, std::istream& in)>;

  /// Opens the files of all shards in order, and passes each behind its header to `read`.
  Result<void> each_shard(const ReadShard& read) const;

  std::vector<std::string> paths_;  // in order of shards
  check::CheckOptions options_;
  nlohmann::json inputs_;
};

}  // namespace pelt::tools::shard
