#pragma once

#include <string>

namespace pelt::tools {

/// Where figures were measured, and with what build.
struct Machine {
  std::string cpu, compiler, build;
  unsigned cores = 0;
};

Machine this_machine();

}  // namespace pelt::tools
