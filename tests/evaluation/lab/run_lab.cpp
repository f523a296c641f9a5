#include "tools/run_program.hpp"

namespace pelt::test {

Ended run_pelt(const TestFolder& folder, const std::vector<std::string>& arguments,
               const std::string& search_path) {
  std::vector<std::string> words = {PELT_COMMAND};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return run_program(folder.path(), words, search_path);
}

}  // namespace pelt::test
