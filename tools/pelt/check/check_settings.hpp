#pragma once

#include "tools/pelt/check/check_question.hpp"
#include "tools/pelt/check/self_arguments.hpp"
#include "tools/pelt/check/verdict.hpp"
#include "tools/pelt/methods/command_methods.hpp"
#include "tools/pelt/scene/colliders.hpp"

#include <optional>
#include <vector>

namespace pelt::tools::check {

/// Validated settings of `pelt check`. Its outputs are in CheckOutputs.
struct CheckSettings {
  methods::MethodKind method = methods::kOnDemand;
  scene::Granularity granularity = scene::Granularity::instance;
  std::optional<std::uint32_t> max_contacts;  ///< per pair of colliders and frame
  /// Nullopt: find triangles that touch; otherwise triangles at most this far apart.
  std::optional<double> clearance;
  std::optional<std::uint32_t> budget;  ///< units of work per pair of colliders and frame
  /// Straight pieces of each step between frames; nullopt: steps are not tested.
  std::optional<std::uint32_t> substeps;
  bool lists_triangles = false;     ///< all pairs of them, not only their number
  bool describes_contacts = false;  ///< describe the geometry of contacts
  std::uint32_t rows_listed = 10;   ///< most rows of each list of the summary
  bool asks_inside = false;         ///< test which bodies are inside others
  SelfChoice self;                  ///< whether bodies are tested against themselves
  std::vector<scenes::NamePair> ignore;
  std::optional<CheckBaseline> baseline;
  FailOn fail_on = FailOn::contact;  ///< `grown` and `newly` need a baseline
  bool allows_empty = false;         ///< otherwise comparing nothing fails
  arguments::FrameRange frames;
  std::uint32_t threads = 0;                   ///< 0 means all cores
  std::optional<std::uint32_t> frame_to_keep;  ///< for CheckReport::kept; nullopt: the worst
};

CheckQuestion question_of(const CheckSettings& settings, const scenes::Scene& scene,
                          const arguments::ModelArguments& models);

}  // namespace pelt::tools::check
