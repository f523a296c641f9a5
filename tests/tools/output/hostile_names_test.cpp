/// Names from files never control the terminal, neither in output nor in error messages.

#include "support/gltf_builder.hpp"
#include "text/printable.hpp"
#include "tools/run_program.hpp"
#include "tools/test_scenes.hpp"

namespace pelt::test {
namespace {

/// Characters that are visible or invisible in a terminal.
const std::string kHostile =
    "a\x1b]0;b\x07\x1b[2J\xc2\x9b"
    "31m\r\n\xe2\x80\xae"
    "c";

/// A name of ten thousand letters of two bytes each.
std::string very_long(const std::string& begin) {
  std::string name = begin;
  for (int i = 0; i < 10000; ++i) name += "é";
  return name;
}

/// A strip of paper and a fan, like `strip_with_fan`, with other names.
GltfBuilder strip_named(const std::string& name) {
  GltfBuilder builder = strip_with_fan();
  for (const char* array : {"nodes", "meshes", "skins", "animations"}) {
    for (std::size_t i = 0; i < builder.document[array].size(); ++i)
      builder.document[array][i]["name"] = name + std::to_string(i);
  }
  return builder;
}

/// The first line that is longer than truncated names allow, or that has control characters.
std::string problem_of(std::string_view text) {
  std::size_t line = 0;
  while (!text.empty()) {
    const text::CodePoint point = text::first_code_point(text);
    line = point.value == '\n' ? 0 : line + point.bytes;
    if (point.value == text::CodePoint::kNone) return "a byte that is not UTF-8";
    if (point.value != '\n' && text::steers_terminal(point.value))
      return "code point " + std::to_string(point.value);
    if (line > 1000) return "a line of more than 1000 bytes";
    text.remove_prefix(point.bytes);
  }
  return "";
}

void expect_harmless(const Ended& run, const std::string& what) {
  EXPECT_EQ(problem_of(run.out), "") << what << '\n' << run.out.substr(0, 3000);
  EXPECT_EQ(problem_of(run.err), "") << what << '\n' << run.err.substr(0, 3000);
}

class HostileNames : public ::testing::TestWithParam<std::vector<std::string>> {};

TEST_P(HostileNames, DoNotSteerTheTerminal) {
  const std::string model = "m" + kHostile + ".glb";
  for (const std::string& name : {kHostile, very_long(kHostile)}) {
    const TestFolder folder;
    write_bytes(folder / model, strip_named(name).glb());
    Words arguments = GetParam();
    arguments.insert(arguments.begin() + 1, {model});
    const Ended run = run_pelt(folder, arguments);
    EXPECT_LE(run.exit_code, 1) << run.err;
    EXPECT_NE(run.out, "");
    expect_harmless(run, arguments[0]);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Verbs, HostileNames,
    ::testing::Values(std::vector<std::string>{"info"},
                      std::vector<std::string>{"check", "--allow-empty"},
                      std::vector<std::string>{"check", "--by", "part", "--contacts"},
                      std::vector<std::string>{"check", "--by", "part", "--glb", kHostile + ".glb"},
                      std::vector<std::string>{"bounds", "--by", "joint"},
                      std::vector<std::string>{"bounds", "--by", "part"},
                      std::vector<std::string>{"distance", "--by", "part"},
                      std::vector<std::string>{"ray", "--from", "0.4,0.5,-3", "--to", "0.4,0.5,3"},
                      std::vector<std::string>{"region", "--sphere", "0,0,0,9", "--by", "part"},
                      std::vector<std::string>{"prepare", "-o", kHostile + ".pelt"},
                      std::vector<std::string>{"pose", "--frame", "0", "-o", kHostile + "p.glb"}));

class HostileRefusal : public ::testing::TestWithParam<std::vector<std::string>> {};

TEST_P(HostileRefusal, DoesNotSteerTheTerminal) {
  const TestFolder folder;
  write_bytes(folder / "a.glb", strip_named(very_long(kHostile)).glb());
  const Ended run = run_pelt(folder, 2, GetParam());
  EXPECT_EQ(lines_of(run.err).size(), 1u);
  expect_harmless(run, GetParam()[0]);
}

INSTANTIATE_TEST_SUITE_P(
    Verbs, HostileRefusal,
    ::testing::Values(std::vector<std::string>{"check", kHostile},
                      std::vector<std::string>{"check", "a.glb", "--clip", "none"},
                      std::vector<std::string>{"check", "a.glb", "--clip", kHostile},
                      std::vector<std::string>{"check", "a.glb", "--" + kHostile},
                      std::vector<std::string>{"check", "a.glb", "--ignore", kHostile + ",b"},
                      std::vector<std::string>{"check", "a.glb", "--jsonl", "no/" + kHostile},
                      std::vector<std::string>{"check", "a.glb", "--frames", kHostile},
                      std::vector<std::string>{"check", "a.glb", "--baseline", kHostile},
                      std::vector<std::string>{"bench", kHostile},
                      std::vector<std::string>{"bench", "s.json", "--methods", kHostile},
                      std::vector<std::string>{"demo", "-o", "a.glb/" + kHostile},
                      std::vector<std::string>{"view", kHostile},
                      std::vector<std::string>{"view", "a.glb", "--clip", kHostile},
                      std::vector<std::string>{"info", "a.glb", "--exclude", "none"},
                      std::vector<std::string>{"info", "a.glb", kHostile},
                      std::vector<std::string>{kHostile}));

TEST(HostileNames, OfABaselineDoNotSteerTheTerminal) {
  const TestFolder folder;
  write_bytes(folder / "a.glb", strip_named(kHostile).glb());
  const std::string known = kHostile + ".jsonl";
  const std::vector<std::string> check = {"check", "a.glb", "--by", "part", "--fail-on", "never"};
  const auto run_with = [&](const std::string& option, const std::string& file) {
    Words arguments = check;
    arguments.insert(arguments.end(), {option, file});
    const Ended run = run_pelt(folder, arguments);
    expect_harmless(run, option);
    return run;
  };
  EXPECT_EQ(run_with("--jsonl", known).exit_code, 0);
  EXPECT_EQ(run_with("--baseline", known).exit_code, 0);
  EXPECT_EQ(run_with("--baseline", "no" + known).exit_code, 2);
  write_text(folder / ("bad" + known), "{\"format\": \"" + very_long("x") + "\"}");
  EXPECT_EQ(run_with("--baseline", "bad" + known).exit_code, 2);
}

/// A scene of two strips of paper whose names, in the file and of the file, are hostile.
std::string write_hostile_scene(const TestFolder& folder) {
  const std::string name = "s" + kHostile + ".json";
  write_bytes(folder / "a.glb", strip_named(kHostile).glb());
  const json scene = {{"models", {{kHostile, "a.glb"}}},
                      {"frames", {{"count", 2}}},
                      {"instances", {{{"model", kHostile}}, {{"model", kHostile}}}}};
  write_text(folder / name, scene.dump());
  return name;
}

TEST(HostileNames, OfABenchDoNotSteerTheTerminal) {
  const TestFolder folder;
  const std::string scene = write_hostile_scene(folder), figures = kHostile + "f.json";
  const auto bench = [&](const std::string& option, const std::string& file) {
    const Ended run = run_pelt(folder, {"bench", scene, "--methods", "on_demand", "--frames", "0:1",
                                        "--repeat", "1", option, file});
    expect_harmless(run, option);
    return run;
  };
  EXPECT_EQ(bench("--json", figures).exit_code, 0);
  EXPECT_EQ(bench("--json", "no/" + figures).exit_code, 2);
}

TEST(HostileNames, OfADemoDoNotSteerTheTerminal) {
  const TestFolder folder;
  const Ended run = run_pelt(folder, {"demo", "-o", "d" + kHostile}, "/nonexistent");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  expect_harmless(run, "demo");
  write_text(folder / ("d" + kHostile) + "/scene.json", "of the user");
  const Ended refused = run_pelt(folder, {"demo", "-o", "d" + kHostile}, "/nonexistent");
  EXPECT_EQ(refused.exit_code, 2);
  expect_harmless(refused, "demo");
}

TEST(HostileNames, StayWhatTheyAreInJson) {
  const TestFolder folder;
  write_bytes(folder / "a.glb", strip_named(kHostile).glb());
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"info", "a.glb", "--json"},
        std::vector<std::string>{"bounds", "a.glb", "--by", "joint", "--jsonl", "-"}}) {
    const Ended run = run_pelt(folder, 0, arguments);
    expect_harmless(run, arguments[0]);
    EXPECT_TRUE(contains(run.out, R"(a\u001b]0;b\u0007\u001b[2J\u009b31m\r\n\u202ec)"));
  }
  const json info = json::parse(run_pelt(folder, {"info", "a.glb", "--json"}).out);
  EXPECT_EQ(info["clips"][0]["name"], kHostile + "0");
}

}  // namespace
}  // namespace pelt::test
