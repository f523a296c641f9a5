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

/// A file that a verb writes, standard output, or nothing. A file is complete, or as it was before:
/// it is written to a temporary file of its own in the same folder, which replaces it in `close`.
/// Standard output, pipes and devices are written in place.
class OutputFile {
 public:
  OutputFile() = default;
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Without a successful `close`, removes the temporary file.
  ~OutputFile();

  /// `name` as for find_output_place, or "" for nothing. Fails if a file cannot be replaced.
  Result<void> open(const std::string& name);

  /// Null where there is nothing to write to.
  std::ostream* stream() { return stream_; }

  /// The temporary file, for a program that writes it by its name; "" for what is written in place.
  const std::filesystem::path& temporary() const { return temporary_; }

  /// Fails if anything has been lost; a file is then as it was before.
  Result<void> close();

  /// Writes all that the output is to hold. Fails where there is nothing to write to.
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

/// The stream for summaries and other words: standard error if any of the outputs is standard
/// output.
std::ostream& words_beside(std::initializer_list<std::string> outputs);

}  // namespace pelt::tools::output
