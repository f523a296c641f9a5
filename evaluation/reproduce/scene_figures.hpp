#pragma once

/// The scenes of experiments and the names of methods in the report. Measures methods on a scene as
/// `pelt bench` does, and makes tables of the figures.

#include "evaluation/methods/lab_methods.hpp"
#include "evaluation/reproduce/report.hpp"
#include "scenes/scene.hpp"
#include "tools/pelt/bench/figures.hpp"

#include <optional>
#include <sstream>
#include <string>
#include <string_view>

namespace pelt::reproduce {

/// Two instances that walk on the spot in different phases and face each other, `distance` apart
/// from middle to middle. The frames are phases at even intervals of the walk.
scenes::Scene facing_pair(const scenes::Character& character, double distance,
                          std::uint32_t phases = 1);

/// The same, with the distance shrinking from frame to frame.
scenes::Scene closing_pair(const scenes::Character& character, double from, double to,
                           std::uint32_t frames);

/// The text of the scenes of evaluation/scenes, so that the program needs no other files.
std::string_view approaching_scene();
std::string_view passing_through_scene();
std::string_view crowd_scene();

/// The name of a method in text, tables and legends of the report. Keys of columns use the name on
/// the command line.
std::string title_of(methods::MethodKind method);

/// Describes the method and names its paper, for readers who do not know the code.
std::string description_of(methods::MethodKind method);

/// The figures of a benchmark. An error if methods gave different answers, which `errors` names.
template <typename Figures>
Result<Figures> agreed(Result<std::optional<Figures>> figures, const std::ostringstream& errors) {
  if (!figures) return figures.error();
  if (!*figures) return Error{ErrorCode::invalid_argument, errors.str()};
  return std::move(**figures);
}

/// Measures all contacts and the first one, with hot caches, on at most `most_frames` evenly spaced
/// frames (in a quick run a fourth of that). Fails if methods give different answers.
Result<tools::bench::SceneFigures> measure_scene(const scenes::Scene& scene,
                                                 std::span<const methods::MethodKind> methods,
                                                 std::uint32_t most_frames,
                                                 const Conditions& conditions);

/// The same for methods with other questions or threads.
Result<tools::bench::SceneFigures> measure_scene(const scenes::Scene& scene,
                                                 std::vector<tools::bench::BenchMethod> methods,
                                                 std::uint32_t most_frames,
                                                 const Conditions& conditions);

/// The methods boxes and self on the instances of a scene against themselves. Fails if self does
/// not give the contacts of brute force.
Result<tools::bench::SceneFigures> measure_against_itself(const scenes::Scene& scene,
                                                          std::uint32_t most_frames,
                                                          const Conditions& conditions);

/// The figures of one method. Precondition: the method was measured.
const tools::bench::Figures& figures_of(const tools::bench::SceneFigures& scene,
                                        std::string_view method, tools::bench::Question question);

/// Time of one method in microseconds per frame. Precondition: the method was measured.
double mean_us(const tools::bench::SceneFigures& figures, methods::MethodKind method,
               tools::bench::Question question);

/// Mean number of contacts per frame.
double contact_count(const tools::bench::SceneFigures& figures);

/// Times and work of every method, one row each.
Table method_table(const std::string& id, const std::string& title,
                   const tools::bench::SceneFigures& figures);

/// How the time splits for methods that skin and refit everything before their query. Precondition:
/// they were measured.
Table eager_split_table(const std::string& id, const std::string& title,
                        const tools::bench::SceneFigures& figures,
                        std::span<const methods::MethodKind> methods);

/// Times per frame that the paper prints, in milliseconds.
struct PrintedTimes {
  double slower_ms = 0, faster_ms = 0;
};

/// A comparison of two methods, and the paper's figure for it.
struct Comparison {
  methods::MethodKind slower, faster;
  tools::bench::Question question;
  std::optional<PrintedTimes> printed;
};

/// The factor by which the second method of each comparison is faster than the first.
Table comparison_table(const std::string& id, const std::string& title,
                       const tools::bench::SceneFigures& figures,
                       std::span<const Comparison> comparisons);

}  // namespace pelt::reproduce
