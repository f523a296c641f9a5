#include "tools/pelt/run_program.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <vector>

extern char** environ;

namespace pelt::tools {

ProgramEnd run_program(std::span<const std::string> words) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
    posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_WRONLY, 0);
  }
  pid_t child = 0;
  const int error =
      posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error == ENOENT) return ProgramEnd::not_found;
  int status = 0;
  if (error != 0 || waitpid(child, &status, 0) != child) return ProgramEnd::failed;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? ProgramEnd::succeeded : ProgramEnd::failed;
}

}  // namespace pelt::tools
