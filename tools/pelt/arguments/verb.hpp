#pragma once

/// The command line of one verb. Hides CLI11 from the verbs: each file that includes CLI11 takes
/// ten seconds more to compile, and twenty with sanitizers.

#include <pelt/result.hpp>

#include <cstdint>
#include <functional>
#include <string>

namespace CLI {
class App;
}

namespace pelt::tools::arguments {

/// Exit codes of the command.
enum class ExitCode : int {
  success = 0,  ///< for `check`: nothing that --fail-on selects
  contact = 1,  ///< only for `check`: what --fail-on selects
  bad_input = 2,
  internal = 3,
};

/// A verb with its arguments, ready to run.
using Command = std::function<Result<ExitCode>()>;

/// Syntax of an option, and its form in --help.
struct OptionSyntax {
  const char* type = nullptr;  ///< name of the value in the help, such as FILE
  bool is_required = false;
  std::uint32_t least = 0;         ///< of a whole number
  std::uint32_t most = 0;          ///< of a whole number; 0: no limit
  const char* excludes = nullptr;  ///< an option, added before, that excludes it, if there is one
  const char* group = nullptr;     ///< a separate heading in the help
};

class Verb {
 public:
  Verb(CLI::App& app, const char* name, const char* description, const char* footer);

  /// Name of the program that the verb belongs to: "pelt" or "pelt-lab".
  std::string program() const;

  /// Adds an option that sets `value`, whose current value is the default. A name without dashes is
  /// a positional argument. A list gets one value for each use of the option. Defined for the types
  /// in verb.cpp.
  template <typename T>
  void option(const char* name, T& value, const std::string& help, const OptionSyntax& syntax = {});

  /// Adds an option that may be given without a value, which then is the first one of `choices`.
  /// The next argument is its value only if it is one of them.
  ///
  /// `choices`: separated by bars, such as "yes|only|no".
  void choice(const char* name, std::string& value, const char* choices, const char* help);

  /// Adds an option without a value.
  void flag(const char* name, bool& value, const char* help);

  /// Stores the command line in `words` if it names this verb: "pelt check a.glb --first".
  void tells(std::string& words) { words_ = &words; }

  /// Sets `chosen` to `command` if the command line names this verb.
  void runs(Command command, Command& chosen);

 private:
  CLI::App& verb_;
  std::string* words_ = nullptr;
};

}  // namespace pelt::tools::arguments
