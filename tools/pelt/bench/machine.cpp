#include "tools/pelt/bench/machine.hpp"

#include <pelt/config.hpp>

#include <sys/utsname.h>
#include <unistd.h>

#include <fstream>
#include <thread>

namespace pelt::tools::bench {
namespace {

/// Only implemented for Linux; otherwise "unknown".
std::string cpu_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != line.npos) return line.substr(colon + 2);
  }
  return "unknown";
}

std::string compiler_name() {
#ifdef __clang__
  return __VERSION__;
#else
  return "GCC " __VERSION__;
#endif
}

/// Zero if the system does not provide it.
double memory_gib() {
  const long pages = sysconf(_SC_PHYS_PAGES), bytes = sysconf(_SC_PAGESIZE);
  if (pages < 0 || bytes < 0) return 0;
  return static_cast<double>(pages) * static_cast<double>(bytes) / (1 << 30);
}

std::string system_name() {
  utsname names;
  if (uname(&names) != 0) return {};
  return std::string(names.sysname) + ' ' + names.release;
}

#ifdef NDEBUG
constexpr const char* kAsserts = "no asserts";
#else
constexpr const char* kAsserts = "asserts";
#endif

}  // namespace

Machine this_machine() {
  return {cpu_name(),
          compiler_name(),
          kAsserts,
          name_of(active_instruction_set()),
          std::thread::hardware_concurrency(),
          PELT_COMPILER_FLAGS,
          system_name(),
          memory_gib()};
}

std::string in_words(const Machine& machine) {
  return machine.cpu + ", " + machine.instruction_set + ", " + machine.compiler + ", " +
         machine.build;
}

}  // namespace pelt::tools::bench
