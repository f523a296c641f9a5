#pragma once

/// The command as a process: its standard streams, its memory, the signals that end it, and the
/// programs that it runs.

#include <pelt/result.hpp>

#include <atomic>
#include <filesystem>
#include <span>
#include <string>

namespace pelt::tools::output {

/// Opens closed standard streams in a mode that cannot be written, so that no file opened later
/// gets their descriptor and receives printed text.
void reserve_standard_streams();

/// Makes allocations beyond the memory of the machine or of the process's cgroups (version 1 or 2),
/// such as that of a container, throw `std::bad_alloc` from now on. By default, Linux grants more
/// memory than there is, and kills a process that uses it. Does nothing except on Linux.
void limit_memory();

/// When a signal ends the command (SIGINT, SIGTERM, SIGHUP, SIGQUIT or SIGPIPE), removes all
/// unfinished files. The command then ends as the signal would have ended it. Signals that the
/// caller of the command ignores remain ignored. Also makes a write beyond the limit of file sizes
/// fail instead of ending the command. Call once, before threads start.
void remove_unfinished_files_on_signals();

/// Registers a file that is useless before it is complete, during the object's lifetime. Use on one
/// thread only.
class UnfinishedFile {
 public:
  /// Registers a file, which need not exist yet.
  explicit UnfinishedFile(const std::filesystem::path& path);
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;
  ~UnfinishedFile();

 private:
  std::atomic<bool>& is_registered_;
};

enum class ProgramEnd { succeeded, failed, not_found };

/// Runs a program found on PATH and waits for its end. Appends what it prints to `printed` if that
/// is not null, and discards its messages. Ctrl+C ends the program, too, because it belongs to the
/// process group of the command.
ProgramEnd run_program(std::span<const std::string> words, std::string* printed = nullptr);

}  // namespace pelt::tools::output
