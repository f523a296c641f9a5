#pragma once

/// The first and the last line of the file of a shard.

#include <pelt/result.hpp>

#include "tools/pelt/check/check_arguments.hpp"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <string>

namespace pelt::tools::shard {

/// The share of a check's frames that one process queries: the I-th of N runs of consecutive
/// frames, of nearly equal length.
struct Shard {
  std::uint32_t index = 1, count = 1;  ///< index from 1 to count

  /// The indices of its frames, of this number of frames.
  std::size_t begin_of(std::size_t frames) const { return share(frames, index - 1); }
  std::size_t end_of(std::size_t frames) const { return share(frames, index); }

 private:
  std::size_t share(std::uint64_t frames, std::uint64_t shards) const {
    return static_cast<std::size_t>(frames * shards / count);
  }
};

inline constexpr std::uint32_t kMostShards = 1'000'000;

/// Parses "I/N". The option is --shard.
Result<Shard> parse_shard(const std::string& text);

struct ShardHeader {
  Shard shard;
  check::CheckArguments arguments;  ///< see arguments_json
  nlohmann::json question;          ///< the arguments and the hashes of the inputs, to be compared
};

/// The hashes of the scene's file, if it has one, and of its models.
Result<nlohmann::json> inputs_of(const arguments::SceneArguments& arguments,
                                 const scenes::Scene& scene);

nlohmann::ordered_json header_json(const Shard& shard, const check::CheckArguments& arguments,
                                   const nlohmann::json& inputs);

/// Error messages have no place.
Result<ShardHeader> read_header(const std::string& line);

}  // namespace pelt::tools::shard
