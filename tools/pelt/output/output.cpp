#include "tools/pelt/output/output.hpp"

#include "asset/printable.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <fstream>
#include <iostream>

namespace pelt::tools::output {

Error unwritable(const std::string& name) {
  if (name == kStandardOutput) {
    return {
        ErrorCode::unreadable_file,
        "standard output: cannot be written: check that it is open and that the disk has space"};
  }
  return {ErrorCode::unreadable_file,
          name + ": cannot be written: check that its folder exists and that the disk has space"};
}

Result<void> write_file(const std::filesystem::path& path, std::span<const std::byte> bytes) {
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (file) return {};
  return unwritable(path.string());
}

void print_written(const std::string& name, std::ostream& words) {
  if (!name.empty() && name != kStandardOutput) words << "wrote " << asset::printable(name) << '\n';
}

Result<void> check_writable(const std::filesystem::path& path) {
  std::error_code ignored;
  const bool is_new = !std::filesystem::exists(path, ignored);
  if (!std::ofstream(path, std::ios::app)) return unwritable(path.string());
  if (is_new) std::filesystem::remove(path, ignored);
  return {};
}

Result<void> flush_standard_output() {
  std::cout.flush();
  if (std::cout) return {};
  return unwritable(kStandardOutput);
}

void reserve_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    const bool closed = fcntl(stream, F_GETFD) == -1;
    if (closed) open("/dev/null", O_RDONLY);  // takes the lowest free number, which is this one
  }
}

}  // namespace pelt::tools::output
