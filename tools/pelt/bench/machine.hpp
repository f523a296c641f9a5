#pragma once

#include <string>

namespace pelt::tools::bench {

/// Machine and build of a measurement.
struct Machine {
  std::string cpu, compiler, build;
  std::string instruction_set;  ///< of queries, see pelt/config.hpp
  unsigned cores = 0;
  std::string flags;   ///< compiler flags
  std::string system;  ///< operating system and release; may be empty
  double memory_gib = 0;
};

Machine this_machine();

/// "AMD EPYC, avx2, GCC 12.2.0, no asserts"
std::string in_words(const Machine& machine);

}  // namespace pelt::tools::bench
