#include "tools/pelt/output/output_file.hpp"

#include "tools/pelt/output/output.hpp"
#include "tools/pelt/output/text.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <iostream>
#include <random>
#include <utility>

namespace pelt::tools::output {
namespace {

namespace fs = std::filesystem;

/// An unused name in the folder. Has the extension of the file, because programs recognise kinds of
/// files by it.
fs::path temporary_beside(const fs::path& path) {
  std::random_device random;
  const std::uint64_t number = std::uint64_t{random()} << 32 | random();
  return path.parent_path() / (".pelt-" + hex16(number) + ".partial" + path.extension().string());
}

/// Whether the file at `path` may be replaced. `known` describes the file unless it is new.
bool is_replaceable(const fs::path& path, struct stat& known, bool& is_new) {
  is_new = stat(path.c_str(), &known) != 0 && errno == ENOENT;
  if (is_new) return path.has_filename();
  if (S_ISDIR(known.st_mode)) errno = EISDIR;
  return !S_ISDIR(known.st_mode) && access(path.c_str(), W_OK) == 0;
}

/// Copies owner and permissions of the file that `descriptor` will replace. Only the superuser can
/// change owners, so a failure is not an error.
void take_over(int descriptor, const struct stat& known) {
  if (fchown(descriptor, known.st_uid, known.st_gid) != 0) errno = 0;
  fchmod(descriptor, known.st_mode & 07777);
}

}  // namespace

OutputFile::~OutputFile() {
  if (!temporary_.empty()) unlink(temporary_.c_str());
}

Result<void> OutputFile::open(const std::string& name) {
  name_ = name;
  if (name.empty()) return {};
  const OutputPlace place = find_output_place(name);
  if (place.kind == OutputPlace::Kind::standard_output) {
    stream_ = &std::cout;
    return {};
  }
  if (!open_place(place)) return failure(errno);
  stream_ = &file_;
  return {};
}

bool OutputFile::open_place(const OutputPlace& place) {
  if (place.kind == OutputPlace::Kind::file) return open_beside(place.path);
  const int descriptor = place.kind == OutputPlace::Kind::descriptor
                             ? fcntl(place.descriptor, F_DUPFD_CLOEXEC, 0)
                             : ::open(place.path.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor >= 0) buffer_.open(descriptor);
  return descriptor >= 0;
}

bool OutputFile::open_beside(const fs::path& path) {
  struct stat known = {};
  bool is_new = false;
  if (!is_replaceable(path, known, is_new)) return false;
  place_ = path;
  int descriptor = -1;
  do {
    temporary_ = temporary_beside(path);
    unfinished_.emplace(temporary_);
    descriptor = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  } while (descriptor < 0 && errno == EEXIST);
  if (descriptor < 0) {
    temporary_.clear();
    unfinished_.reset();
    return false;
  }
  if (!is_new) take_over(descriptor, known);
  buffer_.open(descriptor);
  return true;
}

Result<void> OutputFile::close() {
  if (stream_ == nullptr) return {};
  std::ostream& stream = *std::exchange(stream_, nullptr);
  if (&stream == &std::cout) return flush_standard_output();
  if (!buffer_.close() || !stream) return failure(buffer_.error());
  return move_into_place() ? Result<void>() : failure(errno);
}

Result<void> OutputFile::write_and_close(std::span<const std::byte> bytes) {
  if (stream_ == nullptr) return unwritable(name_);
  stream_->write(reinterpret_cast<const char*>(bytes.data()),
                 static_cast<std::streamsize>(bytes.size()));
  return close();
}

bool OutputFile::move_into_place() {
  if (temporary_.empty()) return true;
  if (rename(temporary_.c_str(), place_.c_str()) != 0) return false;
  temporary_.clear();
  unfinished_.reset();
  return true;
}

Error OutputFile::failure(int error) const { return unwritable(name_, error); }

Result<void> write_file(const std::string& name, std::span<const std::byte> bytes) {
  OutputFile file;
  if (const auto opened = file.open(name); !opened) return opened;
  return file.write_and_close(bytes);
}

std::ostream& words_beside(std::initializer_list<std::string> outputs) {
  const bool taken = std::any_of(outputs.begin(), outputs.end(), is_standard_output);
  return taken ? std::cerr : std::cout;
}

}  // namespace pelt::tools::output
