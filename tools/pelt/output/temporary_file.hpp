#pragma once

#include <pelt/result.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <utility>

namespace pelt::tools::output {

/// A file for results that do not fit in memory, in the folder TMPDIR, or /tmp. The file has no
/// name, so the system frees it when the process ends, whatever ends it. The first `append` creates
/// the file.
class TemporaryFile {
 public:
  TemporaryFile() = default;
  TemporaryFile(TemporaryFile&& other) noexcept { *this = std::move(other); }
  TemporaryFile& operator=(TemporaryFile&& other) noexcept;
  ~TemporaryFile();

  /// Does nothing after a failure.
  void append(std::span<const std::byte> bytes);

  /// Copies `bytes.size()` bytes from `offset`. Returns false if this or anything earlier failed.
  bool read(std::uint64_t offset, std::span<std::byte> bytes) const;

  /// Removes the content.
  void clear();

  /// Error that names the folder if anything failed.
  Result<void> status() const;

 private:
  void open();
  void fail(int error) const;

  std::filesystem::path folder_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
  mutable int error_ = 0;  // errno of the first failure
};

}  // namespace pelt::tools::output
