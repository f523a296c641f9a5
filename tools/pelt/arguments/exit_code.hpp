#pragma once

#include <pelt/result.hpp>

#include <functional>

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

}  // namespace pelt::tools::arguments
