#pragma once

/// Files that are being written, and are useless before they are complete; and programs that write
/// such files.

#include <sys/types.h>

#include <csignal>
#include <filesystem>

namespace pelt::tools::output {

/// When a signal ends the command (SIGINT, SIGTERM, SIGHUP, SIGQUIT or SIGPIPE), kills the running
/// program and removes all unfinished files. The command then ends as the signal would have ended
/// it. Signals that the caller of the command ignores remain ignored. Also makes a write beyond the
/// limit of file sizes fail instead of ending the command. Call once, before threads start.
void remove_unfinished_files_on_signals();

/// Registers a file as unfinished during the object's lifetime. Use on one thread only.
class UnfinishedFile {
 public:
  /// Registers a file, which need not exist yet.
  explicit UnfinishedFile(const std::filesystem::path& path);
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;
  ~UnfinishedFile();

 private:
  std::size_t slot_;
};

/// Postpones the signals that end the command until the object is destroyed. Affects one thread.
class SignalsBlocked {
 public:
  SignalsBlocked();
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;
  ~SignalsBlocked();

 private:
  sigset_t before_;
};

/// Registers a child process, the leader of its process group, until the object is destroyed: a
/// signal that ends the command kills the group. Only one at a time. Destroy on the thread that has
/// waited for the process.
class RunningProgram {
 public:
  explicit RunningProgram(pid_t leader);
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;
  ~RunningProgram();
};

}  // namespace pelt::tools::output
