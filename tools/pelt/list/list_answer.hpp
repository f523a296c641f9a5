#pragma once

/// The answer for a list of scenes: a line, the answers of all scenes in order, and the totals.

#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/list/list_query.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace pelt::tools::list {

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

/// Writes the answers of all scenes of a list and prints the summary. Of the arguments, uses only
/// --jsonl and --list.
Result<arguments::ExitCode> write_list(const check::CheckArguments& arguments, std::size_t scenes,
                                       const SceneSource& source);

/// `pelt check --scenes`, without shards.
Result<arguments::ExitCode> run_list(const check::CheckArguments& arguments);

}  // namespace pelt::tools::list
