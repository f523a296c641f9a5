#pragma once

/// Files of shards: a header, three lines per frame or the lines of each scene, and a last line
/// that shows that the file is complete. docs/pelt.1 describes the keys.

#include "base/hash.hpp"
#include "tools/pelt/check/check_run.hpp"
#include "tools/pelt/list/list_query.hpp"
#include "tools/pelt/shard/shard_header.hpp"

#include <functional>
#include <ostream>
#include <span>
#include <string>
#include <vector>

namespace pelt::tools::shard {

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

  /// The arguments of the check, without those of its outputs and its verdict.
  const check::CheckArguments& arguments() const { return arguments_; }

  /// Returns an error if the inputs are no longer those of the shards.
  Result<void> check_inputs(const scenes::Scene& scene) const;

  /// Passes the answers of all frames to `use`, in order. Reads them on `settings.threads` threads,
  /// and keeps at most four answers per thread in memory. Error messages name the file.
  Result<void> replay(const scene::StagedScene& staged, const check::CheckSettings& settings,
                      const check::UseAnswer& use) const;

  bool is_of_list() const { return !arguments_.scenes.empty(); }

  /// The number of scenes of the list. Precondition: is_of_list().
  std::size_t scenes() const { return scenes_of(inputs_); }

  /// Passes the answers of all scenes to `use`, in order. Keeps one in memory. Precondition:
  /// is_of_list().
  Result<void> replay_scenes(const list::UseScene& use) const;

 private:
  using ReadShard =
      std::function<Result<void>(const std::string& path, const Shard& shard, std::istream& in)>;

  /// Opens the files of all shards in order, and passes each behind its header to `read`.
  Result<void> each_shard(const ReadShard& read) const;

  std::vector<std::string> paths_;  // in order of shards
  check::CheckArguments arguments_;
  nlohmann::json inputs_;
};

}  // namespace pelt::tools::shard
