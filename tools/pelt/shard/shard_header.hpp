#pragma once

/// The first and the last line of the file of a shard.

#include <pelt/result.hpp>

#include "tools/pelt/check/check_arguments.hpp"
#include "tools/pelt/list/list_query.hpp"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <string>

namespace pelt::tools::shard {

/// The share of a check's frames, or of the scenes of a list, that one process queries: the I-th of
/// N runs of consecutive ones, of nearly equal length.
struct Shard {
  std::uint32_t index = 1, count = 1;  ///< index from 1 to count

  /// The indices of its frames or scenes, of this number.
  std::size_t begin_of(std::size_t number) const { return share(number, index - 1); }
  std::size_t end_of(std::size_t number) const { return share(number, index); }

 private:
  std::size_t share(std::uint64_t number, std::uint64_t shards) const {
    return static_cast<std::size_t>(number * shards / count);
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

/// The hash of the list, with its number of scenes, and that of the baseline, if there is one.
Result<nlohmann::json> inputs_of(const list::ListPlan& plan);

/// The number of scenes of a list. Precondition: `inputs` are those of a list.
std::size_t scenes_of(const nlohmann::json& inputs);

nlohmann::ordered_json header_json(const Shard& shard, const check::CheckArguments& arguments,
                                   const nlohmann::json& inputs);

/// Error messages have no place.
Result<ShardHeader> read_header(const std::string& line);

}  // namespace pelt::tools::shard
