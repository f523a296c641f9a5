#pragma once

/// Methods on a scene, measured as `pelt bench` measures them, and what becomes of it in the
/// report.

#include "evaluation/methods/lab_methods.hpp"
#include "evaluation/reproduce/experiment.hpp"
#include "scenes/scene.hpp"
#include "tools/pelt/bench/bench_report.hpp"

#include <optional>

namespace pelt::reproduce {

/// All contacts and the first one, with hot caches, on at most `most_frames` frames, evenly over
/// all (in a quick run a fourth of that). Fails where methods answer differently.
Result<tools::SceneFigures> measure_scene(const scenes::Scene& scene,
                                          std::span<const methods::MethodKind> methods,
                                          std::uint32_t most_frames, const Conditions& conditions);

/// The same of engines that are no methods of the command.
Result<tools::SceneFigures> measure_scene(const scenes::Scene& scene,
                                          std::vector<tools::Engine> engines,
                                          std::uint32_t most_frames, const Conditions& conditions);

/// What one engine was measured to do. Precondition: it was.
const tools::Figures& figures_of(const tools::SceneFigures& scene, std::string_view engine,
                                 tools::Question question);

/// Microseconds a frame of one method. Precondition: it was measured.
double mean_us(const tools::SceneFigures& figures, methods::MethodKind method,
               tools::Question question);

/// Of a frame, in the mean.
double contact_count(const tools::SceneFigures& figures);

/// Times and work of every method, a row each.
Table method_table(const std::string& id, const std::string& title,
                   const tools::SceneFigures& figures);

/// Where the time of methods goes that skin and refit everything before their query. Precondition:
/// they were measured.
Table eager_split_table(const std::string& id, const std::string& title,
                        const tools::SceneFigures& figures,
                        std::span<const methods::MethodKind> methods);

/// Milliseconds of a frame that the paper prints.
struct PrintedTimes {
  double slower_ms = 0, faster_ms = 0;
};

/// One comparison, and what the paper prints for it.
struct Comparison {
  methods::MethodKind slower, faster;
  tools::Question question;
  std::optional<PrintedTimes> printed;
};

/// How many times faster the second method of each comparison is than the first.
Table comparison_table(const std::string& id, const std::string& title,
                       const tools::SceneFigures& figures, std::span<const Comparison> comparisons);

}  // namespace pelt::reproduce
