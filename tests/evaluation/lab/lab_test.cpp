/// The program pelt-lab: the verbs of the command with additional methods.

#include "evaluation/methods/lab_methods.hpp"
#include "tools/run_program.hpp"
#include "tools/scene/every_method.hpp"
#include "tools/test_scenes.hpp"

#include <map>

namespace pelt::test {

Ended run_pelt(const TestFolder& folder, const std::vector<std::string>& arguments,
               const std::string& search_path) {
  std::vector<std::string> words = {PELT_COMMAND};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return run_program(folder.path(), words, search_path);
}

/// The methods that the command does not have, and one that they are compared with.
methods::MethodKinds every_method() {
  static const std::vector<methods::MethodKind> methods = [] {
    std::vector<methods::MethodKind> all = {methods::kOnDemand};
    for (const methods::MethodKind& kind : lab::kLabMethods)
      if (!methods::find_method(methods::kCommandMethods, kind.name)) all.push_back(kind);
    return all;
  }();
  return methods;
}

namespace {

json bench(const TestFolder& folder, std::vector<std::string> options) {
  options.insert(options.begin(), {"bench", "scene.json", "--repeat", "1", "--json", "a.json"});
  const Ended run = run_pelt(folder, options);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  return json::parse(read_text(folder / "a.json"));
}

TEST(Lab, NamesItsVerbsAndItself) {
  const TestFolder folder;
  const Ended help = run_pelt(folder, {"--help"});
  for (const char* verb : {"pelt-lab", "bench", "check", "reproduce"})
    EXPECT_NE(help.out.find(verb), std::string::npos) << verb;
  EXPECT_EQ(run_pelt(folder, {"--version"}).out, "pelt-lab 0.1.0\n");
  const Ended wrong = run_pelt(folder, {"reprodce"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_EQ(
      wrong.err,
      "pelt-lab: error: \"reprodce\" is not a verb, did you mean \"reproduce\"?: see pelt-lab "
      "--help\n");
}

TEST(Lab, ChecksByEveryMethodWithTheSameAnswer) {
  const TestFolder folder;
  write_limbs(folder);
  std::map<std::string, json> last_lines;
  for (const methods::MethodKind& kind : lab::kLabMethods) {
    const std::string method(kind.name);
    const Ended run = run_pelt(folder, {"check", "scene.json", "--method", method, "--jsonl", "-"});
    ASSERT_EQ(run.exit_code, 1) << method << run.err;
    last_lines[method] = json::parse(lines_of(run.out).back());
    EXPECT_EQ(last_lines[method]["hash"], last_lines.begin()->second["hash"]) << method;
  }
  EXPECT_EQ(last_lines.size(), 14u);
  EXPECT_TRUE(last_lines["on_demand"]["hash"].is_string());
  // On demand poses far fewer vertices than methods that pose all; rigid methods refit nothing.
  for (const std::string prefix : {"", "paper_"}) {
    const json& lazy = last_lines[prefix.empty() ? "on_demand" : "paper"]["counters"];
    const json& eager = last_lines[prefix + "eager"]["counters"];
    EXPECT_LT(lazy["posed_vertices"], eager["posed_vertices"]) << prefix;
    EXPECT_LT(lazy["refits"], eager["refits"]) << prefix;
    EXPECT_EQ(last_lines[prefix + "rigid"]["counters"]["refits"], 0) << prefix;
  }
}

TEST(Lab, BenchesEveryMethodBesideRigid) {
  const TestFolder folder;
  write_limbs(folder);
  std::string all;
  for (const methods::MethodKind& kind : lab::kLabMethods)
    all += (all.empty() ? "" : ",") + std::string(kind.name);
  const std::vector<std::string> options = {"--methods", all,   "--queries", "all",
                                            "--caches",  "hot", "--frames",  "4:7"};
  const json file = bench(folder, options);
  EXPECT_EQ(file["scenes"][0]["methods"].size(), 14u);
  std::vector<std::string> words = {"bench", "scene.json", "--repeat", "1", "--against", "a.json"};
  words.insert(words.end(), options.begin(), options.end());
  const Ended again = run_pelt(folder, words);
  EXPECT_EQ(again.exit_code, 0) << again.err;
  const std::size_t columns = again.out.find("of rigid");
  ASSERT_NE(columns, std::string::npos) << "in the table of times";
  EXPECT_NE(again.out.find("of rigid", columns + 1), std::string::npos) << "in the comparison";
}

}  // namespace

}  // namespace pelt::test
