#include "support/call_program.hpp"
#include "tools/pelt/verbs/commands.hpp"
#include "tools/run_program.hpp"

namespace pelt::test {

Ended run_pelt(const TestFolder& folder, const Words& arguments, const std::string& search_path) {
  const CalledProgram called(folder.path(), search_path);
  Words words = {"pelt"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  const int count = static_cast<int>(pointers.size());
  pointers.push_back(nullptr);
  Ended run;
  run.exit_code = tools::arguments::run_command_line(tools::verbs::kPelt, count, pointers.data());
  run.out = called.out();
  run.err = called.err();
  return run;
}

Ended run_pelt(const TestFolder& folder, int exit_code, const Words& arguments) {
  Ended run = run_pelt(folder, arguments);
  EXPECT_EQ(run.exit_code, exit_code) << ::testing::PrintToString(arguments) << '\n'
                                      << run.out << run.err;
  return run;
}

}  // namespace pelt::test
