#pragma once

/// Runs `pelt bench` on scenes: builds models, compares the answers of all methods, and measures
/// them.

#include "tools/pelt/bench/figures.hpp"

#include <optional>
#include <string>

namespace pelt::tools::bench {

struct BenchSettings {
  std::string program = "pelt";  ///< for messages
  std::vector<BenchMethod> methods;
  bool is_self = false;  ///< each instance against itself, with methods of `self_method`
  std::vector<Question> questions;
  std::vector<Cache> caches = {Cache()};
  std::uint32_t repetitions = kEnoughRepetitions;
  std::optional<arguments::FrameRange> frames;  ///< nullopt: all frames of the scene
  arguments::ModelArguments models;
};

/// Returns the scene's figures. If a method's answers differ from those of the reference (the
/// method paper, or brute force for self-collision, morph targets and dual quaternions), prints its
/// name to `errors`, measures nothing, and returns nullopt.
Result<std::optional<SceneFigures>> bench_scene(const scenes::Scene& scene,
                                                const BenchSettings& settings,
                                                std::ostream& errors);

/// Prints that a method gives another answer than the reference. `question` follows the hash,
/// unless empty: " to the query pairs".
void print_disagreement(const std::string& program, const scenes::Scene& scene,
                        const std::string& method, std::uint64_t hash, const std::string& question,
                        const std::string& reference, std::uint64_t expected, std::ostream& errors);

}  // namespace pelt::tools::bench
