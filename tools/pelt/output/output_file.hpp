#pragma once

/// Output files of the command, and messages about unwritable files.

#include <pelt/result.hpp>

#include "tools/pelt/output/process.hpp"

#include <cstddef>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <ostream>
#include <span>
#include <streambuf>
#include <string>
#include <vector>

namespace pelt::tools::output {

/// The name of standard output as a file argument.
inline constexpr const char* kStandardOutput = "-";

/// The destination of an output, with links resolved.
struct OutputPlace {
  enum class Kind {
    standard_output,
    descriptor,  ///< another inherited descriptor, such as /dev/stderr
    device,      ///< a device or a pipe, written directly
    file,        ///< a file to replace or to create
  };

  Kind kind = Kind::file;
  std::filesystem::path path;  ///< of a device or a file
  int descriptor = -1;
};

/// `name`: as given by the user, a path (which may refer to an open descriptor: /dev/stdout,
/// /dev/fd/3) or kStandardOutput.
OutputPlace find_output_place(const std::string& name);

/// Whether `name` refers to standard output.
bool is_standard_output(const std::string& name);

/// A stream buffer that writes to a file descriptor and stores the first error.
class DescriptorBuffer : public std::streambuf {
 public:
  DescriptorBuffer() = default;
  DescriptorBuffer(const DescriptorBuffer&) = delete;
  DescriptorBuffer& operator=(const DescriptorBuffer&) = delete;
  ~DescriptorBuffer() override;  ///< closes the descriptor; discards buffered bytes

  /// Takes ownership of a descriptor.
  void open(int descriptor);

  /// Writes the rest and closes the descriptor. Returns false if anything was lost since `open`.
  bool close();

  /// The errno of the first failure; 0 if there was none.
  int error() const { return error_; }

 protected:
  int_type overflow(int_type c) override;
  int sync() override;

 private:
  int descriptor_ = -1;
  int error_ = 0;
  std::vector<char> buffer_;
};

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
  int open_place(const OutputPlace& place);
  int open_beside(const std::filesystem::path& path);

  std::string name_;
  std::filesystem::path place_, temporary_;  // "": written in place
  std::optional<UnfinishedFile> unfinished_;
  DescriptorBuffer buffer_;
  std::ostream file_{&buffer_};
  std::ostream* stream_ = nullptr;
};

/// Opens an output, writes it and closes it.
Result<void> write_file(const std::string& name, std::span<const std::byte> bytes);

/// The error for an output that cannot be written. `name`: as given by the user, a path or
/// kStandardOutput. `error`: the errno with the cause, or 0.
Error unwritable(const std::string& name, int error = 0);

/// Returns an error if any output to std::cout since the start was lost.
Result<void> flush_standard_output();

/// The stream for summaries: standard error if any of the outputs is standard output.
std::ostream& words_beside(std::initializer_list<std::string> outputs);

/// Prints the name of a written file. Prints nothing for standard output and for "", which is no
/// file.
void print_written(const std::string& name, std::ostream& words);

}  // namespace pelt::tools::output
