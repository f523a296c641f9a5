#pragma once

#include <pelt/result.hpp>

#include "tools/pelt/output/descriptor_buffer.hpp"
#include "tools/pelt/output/output_place.hpp"
#include "tools/pelt/output/unfinished_files.hpp"

#include <cstddef>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <ostream>
#include <span>
#include <string>

namespace pelt::tools::output {

/// A file that a verb writes, standard output, or nothing. A file is either complete or unchanged:
/// the content goes to a temporary file in the same folder, which replaces the file in `close`.
/// Standard output, pipes and devices are written directly.
class OutputFile {
 public:
  OutputFile() = default;
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Removes the temporary file unless `close` succeeded.
  ~OutputFile();

  /// `name`: as for find_output_place, or "" for nothing. Returns an error if the file cannot be
  /// replaced.
  Result<void> open(const std::string& name);

  /// Null if there is no output.
  std::ostream* stream() { return stream_; }

  /// Returns an error if anything was lost; the file is then unchanged.
  Result<void> close();

  /// Writes the whole output. Returns an error if there is no output.
  Result<void> write_and_close(std::span<const std::byte> bytes);

 private:
  bool open_place(const OutputPlace& place);
  bool open_beside(const std::filesystem::path& path);
  bool move_into_place();
  Error failure(int error) const;

  std::string name_;
  std::filesystem::path place_, temporary_;  // "": written in place
  std::optional<UnfinishedFile> unfinished_;
  DescriptorBuffer buffer_;
  std::ostream file_{&buffer_};
  std::ostream* stream_ = nullptr;
};

/// Opens an output, writes it and closes it.
Result<void> write_file(const std::string& name, std::span<const std::byte> bytes);

/// The stream for summaries: standard error if any of the outputs is standard output.
std::ostream& words_beside(std::initializer_list<std::string> outputs);

}  // namespace pelt::tools::output
