#include "tools/pelt/output/output.hpp"

#include "asset/printable.hpp"
#include "tools/pelt/output/output_place.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <iostream>
#include <system_error>

namespace pelt::tools::output {

Error unwritable(const std::string& name, int error) {
  const std::string why = error == 0 ? "" : ": " + std::generic_category().message(error);
  if (name == kStandardOutput) {
    return {ErrorCode::unreadable_file, "standard output: cannot be written" + why +
                                            ": check that it is open and that the disk has space"};
  }
  return {ErrorCode::unreadable_file,
          name + ": cannot be written" + why +
              ": check that its folder exists and that the disk has space"};
}

void print_written(const std::string& name, std::ostream& words) {
  if (!name.empty() && !is_standard_output(name))
    words << "wrote " << asset::printable(name) << '\n';
}

Result<void> flush_standard_output() {
  std::cout.flush();
  if (std::cout) return {};
  return unwritable(kStandardOutput);
}

void reserve_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    const bool closed = fcntl(stream, F_GETFD) == -1;
    if (closed) open("/dev/null", O_RDONLY);  // gets the lowest free number, which is this one
  }
}

}  // namespace pelt::tools::output
