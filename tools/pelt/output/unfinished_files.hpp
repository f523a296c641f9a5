#pragma once

/// Files that are being written, and are useless before they are complete.

#include <filesystem>

namespace pelt::tools::output {

/// Removes all unfinished files when a signal ends the command (SIGINT, SIGTERM, SIGHUP, SIGQUIT or
/// SIGPIPE). The command then ends as the signal would have ended it. Signals that the caller of
/// the command ignores remain ignored. Also makes a write beyond the limit of file sizes fail
/// instead of ending the command. Call once, before threads start.
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

}  // namespace pelt::tools::output
