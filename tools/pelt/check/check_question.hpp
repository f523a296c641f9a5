#pragma once

/// Everything that the answer of a check depends on, except for the scene's instances.

#include "scenes/scene.hpp"
#include "tools/pelt/arguments/values.hpp"
#include "tools/pelt/check/self_arguments.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace pelt::tools::check {

struct CheckQuestion {
  std::string method, by;
  arguments::FrameRange frames;
  double fps = 30;
  std::vector<std::string> clips;  ///< of the takes, in order; empty without takes
  std::optional<std::uint32_t> max_contacts;
  std::optional<double> clearance;
  std::optional<std::uint32_t> budget;
  std::optional<std::uint32_t> substeps;  ///< of --between
  bool pairs = false, contacts = false, inside = false;
  SelfChoice self;
  std::vector<scenes::NamePair> ignore;
  std::vector<std::string> exclude;
  bool no_unskinned = false, renormalise = false;
  std::map<std::string, std::string> skinning;  ///< by models
};

/// "options" of the header of `pelt check --jsonl`.
nlohmann::ordered_json question_json(const CheckQuestion& question);

}  // namespace pelt::tools::check
