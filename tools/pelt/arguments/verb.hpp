#pragma once

/// The command line of one verb. Each file that includes CLI11 takes a compiler ten seconds more,
/// and twenty beside sanitizers: this stands between it and the verbs.

#include "tools/pelt/arguments/exit_code.hpp"

#include <string>

namespace CLI {
class App;
}

namespace pelt::tools::arguments {

/// How an option is given, and how --help shows it.
struct OptionSyntax {
  const char* type = nullptr;  ///< placeholder for the value in the help
  bool is_required = false;
  int most = 0;                    ///< a number from 0 to this; 0: any
  const char* excludes = nullptr;  ///< an option, added before, that may not be given beside it
  const char* group = nullptr;     ///< a heading of its own
};

class Verb {
 public:
  Verb(CLI::App& app, const char* name, const char* description, const char* footer);

  /// Adds an option whose value goes to `value`, which has the default until then; a name without
  /// dashes is that of arguments without one. A list takes one value each time the option is given.
  /// Defined for the types of verb.cpp.
  template <typename T>
  void option(const char* name, T& value, const std::string& help, const OptionSyntax& syntax = {});

  /// Adds an option without a value.
  void flag(const char* name, bool& value, const char* help);

  /// When the command line names this verb, `words` becomes what it says: "pelt check a.glb
  /// --first".
  void tells(std::string& words) { words_ = &words; }

  /// `chosen` becomes `command` when the command line names this verb.
  void runs(Command command, Command& chosen);

 private:
  CLI::App& verb_;
  std::string* words_ = nullptr;
};

}  // namespace pelt::tools::arguments
