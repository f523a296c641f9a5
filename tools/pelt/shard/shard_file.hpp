#pragma once

/// Files of shards: a header, a line of JSON per frame, and a last line that shows that the file is
/// complete. docs/pelt.1 describes the keys.

#include "base/hash.hpp"
#include "tools/pelt/check/check_record.hpp"
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

  /// Writes the last line.
  void finish();

 private:
  void write(const nlohmann::ordered_json& value);

  std::ostream& out_;
  detail::Fnv1a64 hash_;
  std::size_t frames_ = 0;
};

/// All shards of one check.
class Shards {
 public:
  /// Opens files in any order, and reads each of them once. Returns an error that names the file or
  /// the shard: for files that are damaged or incomplete, and for shards that are missing, given
  /// twice, or from different checks.
  static Result<Shards> open(std::span<const std::string> paths);

  /// The arguments of the check, without those of its outputs and its verdict.
  const check::CheckArguments& arguments() const { return arguments_; }

  /// Returns an error if the inputs are no longer those of the shards.
  Result<void> check_inputs(const scenes::Scene& scene) const;

  /// Passes the answers of all frames to `use`, in order. Keeps one answer in memory. Error
  /// messages name the file.
  Result<void> replay(
      const scene::StagedScene& staged, const check::CheckSettings& settings,
      const std::function<Result<void>(const check::FrameAnswer& answer)>& use) const;

 private:
  std::vector<std::string> paths_;  // in order of shards
  check::CheckArguments arguments_;
  nlohmann::json inputs_;
};

}  // namespace pelt::tools::shard
