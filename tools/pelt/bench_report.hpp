#pragma once

/// The figures of `pelt bench` for people and for programs.

#include "tools/pelt/bench_measure.hpp"

#include <nlohmann/json.hpp>

#include <ostream>
#include <string>
#include <vector>

namespace pelt::tools {

struct EngineFigures {
  std::string engine;  ///< name of the method
  Measurement measurement;
};

struct SceneFigures {
  std::string scene;
  std::uint64_t triangles = 0;  ///< of all instances
  double build_seconds = 0;     ///< build_model of all characters
  std::vector<EngineFigures> engines;
};

const char* name_of(Question question);
const char* name_of(Cache cache);

void print_figures(const SceneFigures& figures, const BenchSettings& settings, std::ostream& out);

nlohmann::ordered_json figures_json(const std::vector<SceneFigures>& scenes,
                                    const BenchSettings& settings);

}  // namespace pelt::tools
