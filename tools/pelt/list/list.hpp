#pragma once

/// `pelt check --scenes`: checks the scenes of a list, one after the other on each thread. The
/// answer is a line, the answers of all scenes in order, and the totals.

#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/check/options.hpp"
#include "tools/pelt/check/ordered_work.hpp"
#include "tools/pelt/list/entry.hpp"
#include "tools/pelt/output/output_conflicts.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace pelt::tools::list {

/// The scenes of `pelt check --scenes`, and how they are checked.
struct ListPlan {
  check::CheckOptions options;
  std::vector<std::string> scenes;
  std::optional<ListBaseline> baseline;
  std::vector<output::NamedOutput> outputs;  ///< which must not replace a file of a scene

  /// Reads the list and the baseline. Precondition: check::check_options accepts the options.
  static Result<ListPlan> make(const check::CheckOptions& options);
};

/// Warns on standard error if the baseline has scenes that the list lacks, so that lost or renamed
/// scenes are noticed.
void warn_of_missing_scenes(const ListPlan& plan);

/// Uses the answer of a scene.
using UseScene = std::function<Result<void>(const SceneAnswer& answer)>;

/// Checks scenes, given by their indices in the list, on the threads of the options, and passes
/// their answers to `use`, in order (see check::compute_in_order). A scene that cannot be checked
/// has an answer with an error. Memory: for each thread a scene, and the lines of at most four
/// scenes.
Result<void> ask_scenes(const ListPlan& plan, const check::Indices& indices, const UseScene& use);

/// Adds up the answers of scenes.
class ListTally {
 public:
  /// Prints an error message for a scene that could not be checked.
  void add(const SceneEntry& entry);

  std::size_t scenes() const { return entries_.size(); }
  std::size_t unchecked() const { return unchecked_; }

  /// The last line of --jsonl.
  std::string totals() const;

  /// `rows`: the most rows of the list of scenes.
  void print_summary(std::uint32_t rows, std::ostream& out) const;

  /// bad_input if any scene could not be checked.
  arguments::ExitCode exit_code() const;

 private:
  std::size_t count(bool (*is_counted)(const SceneEntry& entry)) const;
  std::optional<std::uint64_t> hash() const;

  std::vector<SceneEntry> entries_;
  std::size_t unchecked_ = 0;
  std::uint64_t frames_ = 0, frames_in_contact_ = 0, contacts_ = 0;
};

/// Passes the answers of all scenes to `use`, in order.
using SceneSource = std::function<Result<void>(const UseScene& use)>;

/// Writes the answers of all scenes of a list and prints the summary. Of the options, uses only
/// --jsonl and --list.
Result<arguments::ExitCode> write_list(const check::CheckOptions& options, std::size_t scenes,
                                       const SceneSource& source);

/// `pelt check --scenes`, without shards.
Result<arguments::ExitCode> run_list(const check::CheckOptions& options);

}  // namespace pelt::tools::list
