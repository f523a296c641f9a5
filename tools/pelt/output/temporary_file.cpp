#include "tools/pelt/output/temporary_file.hpp"

#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

namespace pelt::tools::output {

/// Swaps, so that the destructor of `other` closes the file of this.
TemporaryFile& TemporaryFile::operator=(TemporaryFile&& other) noexcept {
  std::swap(folder_, other.folder_);
  std::swap(descriptor_, other.descriptor_);
  std::swap(size_, other.size_);
  std::swap(error_, other.error_);
  return *this;
}

TemporaryFile::~TemporaryFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void TemporaryFile::append(std::span<const std::byte> bytes) {
  if (descriptor_ < 0 && error_ == 0) open();
  while (!bytes.empty() && error_ == 0) {
    const ssize_t written =
        ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(size_));
    if (written < 0) {
      if (errno != EINTR) fail(errno);
      continue;
    }
    size_ += static_cast<std::uint64_t>(written);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

bool TemporaryFile::read(std::uint64_t offset, std::span<std::byte> bytes) const {
  while (!bytes.empty() && error_ == 0) {
    const ssize_t count =
        ::pread(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) {
      fail(count < 0 ? errno : EIO);  // nothing else shortens the file
    } else {
      offset += static_cast<std::uint64_t>(count);
      bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
  }
  return error_ == 0;
}

void TemporaryFile::clear() {
  size_ = 0;
  if (descriptor_ >= 0 && ::ftruncate(descriptor_, 0) != 0) fail(errno);
}

Result<void> TemporaryFile::status() const {
  if (error_ == 0) return {};
  return Error{ErrorCode::unreadable_file,
               folder_.string() +
                   ": cannot hold a temporary file: " + std::generic_category().message(error_) +
                   ": check the folder and its space, or set TMPDIR to another folder"};
}

void TemporaryFile::open() {
  std::error_code unusable;
  folder_ = std::filesystem::temp_directory_path(unusable);
  if (unusable) {
    const char* chosen = ::getenv("TMPDIR");
    folder_ = chosen == nullptr ? "/tmp" : chosen;
    return fail(unusable.value());
  }
  std::string name = folder_ / "pelt-XXXXXX";
  descriptor_ = ::mkostemp(name.data(), O_CLOEXEC);
  if (descriptor_ < 0) return fail(errno);
  ::unlink(name.c_str());
}

void TemporaryFile::fail(int error) const {
  if (error_ == 0) error_ = error;
}

}  // namespace pelt::tools::output
