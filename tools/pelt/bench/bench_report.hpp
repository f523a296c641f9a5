#pragma once

/// The output of `pelt bench`, as text and as JSON.

#include "tools/pelt/bench/bench_answer.hpp"
#include "tools/pelt/bench/bench_measure.hpp"
#include "tools/pelt/bench/bench_self.hpp"
#include "tools/pelt/bench/bench_sequence.hpp"
#include "tools/pelt/bench/bench_skinning.hpp"

#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace pelt::tools::bench {

/// Figures of one variant of one method.
struct Figures {
  std::string method;
  Asked asked = Asked::pairs;
  std::uint32_t threads = 1;
  Variant variant;
  Answer answer;
  Times times;
};

/// The models of a scene, each once.
struct ModelFigures {
  std::uint64_t triangles = 0, bytes = 0;
  double build_seconds = 0;
};

struct SceneFigures {
  std::string scene;
  std::uint64_t triangles = 0;  ///< of all instances
  std::uint64_t frames = 0;
  std::uint32_t repetitions = 0;
  Time time = Time::thread;
  ModelFigures models;
  std::optional<SelfFilterFigures> self_filters;  ///< if instances are queried against themselves
  Skinning skinning;
  std::optional<SequenceFigures> sequence;  ///< if instances are queried against themselves
  std::vector<Figures> figures;             ///< not empty; grouped by variant
};

const char* name_of(Question question);
const char* name_of(Cache cache);
const char* name_of(Asked asked);
const char* name_of(Time time);

/// Prints the machine of the figures.
void print_machine(std::ostream& out);

void print_figures(const SceneFigures& scene, std::ostream& out);

/// Returns the figures as JSON.
std::string figures_json(const std::vector<SceneFigures>& scenes);

}  // namespace pelt::tools::bench
