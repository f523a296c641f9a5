#include "support/call_program.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <iostream>

namespace pelt::test {
namespace {

/// Nothing that was printed before may arrive in another stream, and no failure may last.
void settle_streams() {
  std::fflush(nullptr);
  for (std::ostream* stream : {&std::cout, &std::cerr, &std::clog}) {
    stream->flush();
    stream->clear();
  }
}

}  // namespace

RedirectedStream::RedirectedStream(int descriptor) : descriptor_(descriptor) {
  settle_streams();
  before_ = dup(descriptor);
  file_ = std::tmpfile();
  dup2(fileno(file_), descriptor_);
}

RedirectedStream::~RedirectedStream() {
  settle_streams();
  dup2(before_, descriptor_);
  close(before_);
  std::fclose(file_);
}

std::string RedirectedStream::text() const {
  settle_streams();
  struct stat state;
  fstat(fileno(file_), &state);
  std::string text(static_cast<std::size_t>(state.st_size), '\0');
  return pread(fileno(file_), text.data(), text.size(), 0) == state.st_size ? text : "";
}

CalledProgram::CalledProgram(const std::filesystem::path& folder, const std::string& search_path)
    : out_(STDOUT_FILENO), err_(STDERR_FILENO) {
  std::filesystem::current_path(folder);
  if (search_path.empty()) return;
  const char* path = std::getenv("PATH");
  search_path_before_ = path == nullptr ? "" : path;
  setenv("PATH", search_path.c_str(), 1);
}

CalledProgram::~CalledProgram() {
  std::filesystem::current_path(folder_before_);
  set_active_instruction_set(instruction_set_before_);
  if (search_path_before_) setenv("PATH", search_path_before_->c_str(), 1);
}

}  // namespace pelt::test
