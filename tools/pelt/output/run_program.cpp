#include "tools/pelt/output/run_program.hpp"

#include "tools/pelt/output/unfinished_files.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <optional>
#include <vector>

extern char** environ;

namespace pelt::tools::output {
namespace {

/// Discards a program's output.
class Silence {
 public:
  Silence() {
    posix_spawn_file_actions_init(&actions_);
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO})
      posix_spawn_file_actions_addopen(&actions_, stream, "/dev/null", O_WRONLY, 0);
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;
  ~Silence() { posix_spawn_file_actions_destroy(&actions_); }

  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

/// The signals that reach a program. It leads a process group, so that the terminal's signals reach
/// only the command, which kills the whole group if `run_program` promises that.
class Signals {
 public:
  Signals() {
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_init(&attributes_);
    posix_spawnattr_setsigmask(&attributes_, &none);
    sigset_t ignored;  // by this command (see unfinished_files.hpp)
    sigemptyset(&ignored);
    sigaddset(&ignored, SIGXFSZ);
    posix_spawnattr_setsigdefault(&attributes_, &ignored);
    const int flags = POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP;
    posix_spawnattr_setflags(&attributes_, static_cast<short>(flags));
  }
  Signals(const Signals&) = delete;
  Signals& operator=(const Signals&) = delete;
  ~Signals() { posix_spawnattr_destroy(&attributes_); }

  const posix_spawnattr_t* get() const { return &attributes_; }

 private:
  posix_spawnattr_t attributes_;
};

}  // namespace

ProgramEnd run_program(std::span<const std::string> words, CtrlC ctrl_c) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  pid_t child = 0;
  std::optional<SignalsBlocked> blocked(std::in_place);
  const int error = posix_spawnp(&child, arguments[0], Silence().get(), Signals().get(),
                                 arguments.data(), environ);
  if (error != 0) return error == ENOENT ? ProgramEnd::not_found : ProgramEnd::failed;
  std::optional<RunningProgram> running;
  if (ctrl_c == CtrlC::ends_both) running.emplace(child);
  blocked.reset();
  int status = 0;
  if (waitpid(child, &status, 0) != child) return ProgramEnd::failed;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? ProgramEnd::succeeded : ProgramEnd::failed;
}

}  // namespace pelt::tools::output
