#pragma once

/// The figures of `pelt bench`, as text and as JSON.

#include "tools/pelt/bench/measure.hpp"
#include "tools/pelt/bench/self_figures.hpp"
#include "tools/pelt/bench/table.hpp"

namespace pelt::tools::bench {

/// Figures of one query to one method, with one state of the caches.
struct Figures {
  std::string method;
  Asked asked = Asked::pairs;
  std::uint32_t threads = 1;
  Question question = Question::all;
  std::string cache = "hot";
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
  Skinning skinning;
  std::optional<SelfFigures> self;  ///< if instances are queried against themselves
  std::vector<Figures> figures;     ///< not empty; grouped by question and cache
};

/// A method that others are compared with, on one thread.
struct Yardstick {
  const char* column;  ///< in a row
  const char* title;   ///< in print
  const char* method;
  bool is_cost = false;         ///< the ratio is the cost over the method, not the speed-up
  bool is_for_pairs = false;    ///< shown for pairs even if the method was not measured
  const char* query = nullptr;  ///< of the method; null: that of the row
};

using Yardsticks = std::span<const Yardstick>;

inline constexpr Yardstick kYardsticks[] = {{"vs_paper", "vs paper", "paper", false, true},
                                            {"vs_eager", "vs eager", "eager", false, true},
                                            {"of_boxes", "of boxes", "boxes", true}};

/// The ratio of the mean times of one of the rows and of a yardstick; null if it is not among the
/// rows.
Row ratio_to(const Yardstick& yardstick, std::span<const Row> rows, const Row& row);

/// Prints a warning if there are few repetitions of each `unit`.
void print_repetitions(std::uint32_t repetitions, const char* unit, std::ostream& out);

void print_figures(const SceneFigures& scene, Yardsticks yardsticks, std::ostream& out);

/// A scene of --json.
Row scene_json(const SceneFigures& scene);

}  // namespace pelt::tools::bench
