#include "base/assert.hpp"

#include <cstdio>
#include <cstdlib>

namespace pelt::detail {

void abort_call(const char* message) {
  std::fputs("pelt: ", stderr);
  std::fputs(message, stderr);
  std::fputs("\n", stderr);
  std::abort();
}

}  // namespace pelt::detail
