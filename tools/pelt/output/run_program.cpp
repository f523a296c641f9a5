#include "tools/pelt/output/run_program.hpp"

#include <sys/wait.h>

#include <array>
#include <cstdio>

namespace pelt::tools::output {
namespace {

/// The exit code of a shell that does not find the program.
constexpr int kNotFound = 127;

}  // namespace

ProgramEnd run_program(std::span<const std::string> words, std::string* printed) {
  std::string command = "exec";
  for (const std::string& word : words) command.append(" ").append(shell_word(word));
  command += printed == nullptr ? " >/dev/null 2>&1" : " 2>/dev/null";
  std::FILE* const output = popen(command.c_str(), "r");
  if (output == nullptr) return ProgramEnd::failed;
  std::array<char, 4096> part;
  while (const std::size_t count = std::fread(part.data(), 1, part.size(), output))
    if (printed != nullptr) printed->append(part.data(), count);
  const int status = pclose(output);
  if (WIFEXITED(status) && WEXITSTATUS(status) == kNotFound) return ProgramEnd::not_found;
  return status == 0 ? ProgramEnd::succeeded : ProgramEnd::failed;
}

std::string shell_word(const std::string& word) {
  constexpr const char* kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-./,:=+@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string quoted(1, '\'');
  for (const char c : word) quoted.append(c == '\'' ? "'\\''" : std::string(1, c));
  return quoted.append(1, '\'');
}

}  // namespace pelt::tools::output
