#pragma once

/// Runs `pelt bench` on scenes: builds models, compares the answers of all methods, and measures
/// them.

#include "tools/pelt/arguments/values.hpp"
#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/bench/bench_report.hpp"

#include <optional>
#include <string>

namespace pelt::tools::bench {

struct BenchSettings {
  std::string program = "pelt";  ///< for messages
  std::vector<BenchMethod> methods;
  bool is_self = false;  ///< each instance against itself, with methods of `self_method`
  std::vector<Question> questions;
  std::vector<Cache> caches;
  std::uint32_t repetitions = kEnoughRepetitions;
  std::optional<arguments::FrameRange> frames;  ///< nullopt: all frames of the scene
  arguments::ModelArguments models;
};

/// Appends the scene's figures. If a method's answers differ from
/// those of the reference (the method paper, or brute force for self-collision), prints its name to
/// `errors`, measures nothing, and returns ExitCode::internal.
Result<arguments::ExitCode> bench_scene(const scenes::Scene& scene, const BenchSettings& settings,
                                        std::vector<SceneFigures>& figures, std::ostream& errors);

}  // namespace pelt::tools::bench
