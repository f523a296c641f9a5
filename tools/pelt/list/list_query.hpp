#pragma once

/// Checks the scenes of a list, one after the other on each thread.

#include "tools/pelt/check/check_arguments.hpp"
#include "tools/pelt/list/list_baseline.hpp"
#include "tools/pelt/list/scene_entry.hpp"
#include "tools/pelt/output/output_conflicts.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pelt::tools::list {

/// The scenes of `pelt check --scenes`, and how they are checked.
struct ListPlan {
  check::CheckArguments arguments;
  std::vector<std::string> scenes;
  std::optional<ListBaseline> baseline;
  std::vector<output::NamedOutput> outputs;  ///< which must not replace a file of a scene

  /// Validates the options, and reads the list and the baseline.
  static Result<ListPlan> make(const check::CheckArguments& arguments);
};

/// Indices of scenes in a list, from `begin` up to `end`, exclusive.
struct SceneIndices {
  std::size_t begin = 0, end = 0;

  std::size_t count() const { return end - begin; }
};

/// Warns on standard error if the baseline has scenes that the list lacks, so that lost or renamed
/// scenes are noticed.
void warn_of_missing_scenes(const ListPlan& plan);

/// Uses the answer of a scene.
using UseScene = std::function<Result<void>(const SceneAnswer& answer)>;

/// Checks scenes on the threads of the arguments and passes their answers to `use`, in order. Calls
/// of `use` follow one another, but on any thread. A scene that cannot be checked has an answer
/// with an error. If there are fewer scenes than threads, the frames of a scene are divided between
/// several. Memory: for each thread a scene, and the lines of at most four scenes.
Result<void> ask_scenes(const ListPlan& plan, const SceneIndices& indices, const UseScene& use);

}  // namespace pelt::tools::list
