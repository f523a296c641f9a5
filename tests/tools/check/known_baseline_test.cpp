#include "tools/pelt/check/settings.hpp"

#include "support/contains.hpp"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

namespace pelt::tools::check {
namespace {

using nlohmann::json;

/// Instances of models with these names, without meshes.
scenes::Scene scene_of(const std::vector<std::string>& models) {
  scenes::Scene scene;
  for (const std::string& model : models) {
    scenes::Character character;
    character.name = model;
    scenes::Instance instance;
    instance.character = static_cast<std::uint32_t>(scene.characters.size());
    scene.characters.push_back(std::move(character));
    scene.instances.push_back(instance);
  }
  return scene;
}

nlohmann::ordered_json asked() {
  CheckSettings settings;
  settings.frames = {0, 10, 1};
  return question_json(settings, {});
}

json place(const std::string& model, std::uint32_t copy, const std::string& joint) {
  return {{"instance", 7}, {"model", model}, {"copy", copy}, {"part", "body"}, {"joint", joint}};
}

/// An answer of `pelt check --jsonl` for a knight and a thief, which tests modify.
struct Answer {
  json header = {
      {"format", "pelt-check"},
      {"version", 1},
      {"instances", {{{"index", 0}, {"model", "knight"}}, {{"index", 1}, {"model", "thief"}}}},
      {"options", asked()}};
  json totals = {{"touches", json::array({{{"a", place("knight", 0, "arm")},
                                           {"b", place("thief", 0, "hips")},
                                           {"worst", {{"frame", 3}, {"contacts", 12}}}}})}};

  std::string text() const { return header.dump() + "\n{\"frame\":0}\n" + totals.dump() + "\n"; }
};

Result<CheckBaseline> parse(const Answer& answer, const nlohmann::ordered_json& question = asked(),
                            const std::vector<std::string>& models = {"knight", "thief"}) {
  return CheckBaseline::parse("b.jsonl", answer.text(), question, scene_of(models));
}

std::string message_of(const Result<CheckBaseline>& result) {
  return result ? "" : result.error().message;
}

TouchName name(const std::string& model, std::uint32_t copy, const std::string& joint) {
  return {{model, copy, "body"}, joint};
}

TEST(KnownBaseline, FindsTheWorstFrameOfTwoPlacesInTheirOrder) {
  const Result<CheckBaseline> baseline = parse({});
  ASSERT_TRUE(baseline) << baseline.error().message;
  EXPECT_EQ(worst_of(baseline->touches(), {name("knight", 0, "arm"), name("thief", 0, "hips")}),
            12u);
  EXPECT_EQ(worst_of(baseline->touches(), {name("knight", 0, "arm"), name("thief", 1, "hips")}),
            0u);
  EXPECT_EQ(baseline->touches().size(), 1u);
  EXPECT_TRUE(baseline->notes().empty());
}

TEST(KnownBaseline, FindsTwoPlacesInAnyOrderAndTheWorstOfEqualNames) {
  Answer answer;
  json again = answer.totals["touches"][0];
  std::swap(again["a"], again["b"]);
  again["worst"]["contacts"] = 5;
  answer.totals["touches"].push_back(again);
  const Result<CheckBaseline> baseline = parse(answer);
  ASSERT_TRUE(baseline) << baseline.error().message;
  EXPECT_EQ(baseline->touches().size(), 1u);
  EXPECT_EQ(worst_of(baseline->touches(), {name("knight", 0, "arm"), name("thief", 0, "hips")}),
            12u);
}

TEST(KnownBaseline, FindsContainedBodiesOnRequest) {
  Answer answer;
  answer.header["options"]["inside"] = true;
  answer.totals["held"] =
      json::array({{{"inner", {{"model", "thief"}, {"copy", 0}}},
                    {"outer", {{"model", "knight"}, {"copy", 0}, {"part", "hall"}}}}});
  nlohmann::ordered_json question = asked();
  EXPECT_TRUE(parse(answer, question)->held().empty());
  question["inside"] = true;
  const Result<CheckBaseline> baseline = parse(answer, question);
  ASSERT_TRUE(baseline) << baseline.error().message;
  EXPECT_EQ(baseline->held(),
            (std::set<CheckBaseline::HeldNames>{{{"thief", 0, ""}, {"knight", 0, "hall"}}}));
  answer.totals.erase("held");
  EXPECT_TRUE(test::contains(message_of(parse(answer, question)), "held: is missing"));
}

TEST(KnownBaseline, FindsTouchesByClip) {
  Answer answer;
  answer.header["options"]["clips"] = {"walk", "idle"};
  answer.totals["touches"][0]["clip"] = "walk";
  EXPECT_TRUE(
      test::contains(message_of(parse(answer)), "was written with all clips of a model ('*')"));
  nlohmann::ordered_json question = asked();
  question["clips"] = {"walk", "run"};
  EXPECT_TRUE(test::contains(message_of(parse({}, question)), "was written without the clip '*'"));
  const Result<CheckBaseline> baseline = parse(answer, question);
  ASSERT_TRUE(baseline) << baseline.error().message;
  const TouchName arm = name("knight", 0, "arm"), hips = name("thief", 0, "hips");
  EXPECT_EQ(worst_of(baseline->touches(), {arm, hips, "walk"}), 12u);
  EXPECT_EQ(worst_of(baseline->touches(), {arm, hips, "run"}), 0u);
  EXPECT_EQ(worst_of(baseline->touches(), {arm, hips}), 0u);
  ASSERT_EQ(baseline->notes().size(), 1u);
  EXPECT_EQ(baseline->notes()[0],
            "clips was [\"walk\",\"idle\"] in the baseline and is [\"walk\",\"run\"] now");
}

TEST(KnownBaseline, NotesOptionsThatAreStatedIfGiven) {
  nlohmann::ordered_json question = asked();
  EXPECT_FALSE(question.contains("budget"));
  question["budget"] = 5;
  const Result<CheckBaseline> baseline = parse({}, question);
  ASSERT_TRUE(baseline) << baseline.error().message;
  ASSERT_EQ(baseline->notes().size(), 1u);
  EXPECT_EQ(baseline->notes()[0], "budget was null in the baseline and is 5 now");
}

TEST(KnownBaseline, RefusesTheAnswerToAnotherQuestion) {
  struct Case {
    const char* key;
    json value;
    std::string words;
  };
  for (const auto& [key, value, words] :
       {Case{"by", "part",
             "was written --by part, but this check is --by instance: use the same options, or "
             "write a new baseline"},
        Case{"clearance", 0.5,
             "was written --clearance 0.5, but this check is without --clearance: use the same "
             "options, or write a new baseline"},
        Case{"max_contacts", 1,
             "was written with --first or --max-contacts and lacks contacts: write a new baseline "
             "without them"}}) {
    Answer answer;
    answer.header["options"][key] = value;
    EXPECT_EQ(message_of(parse(answer)), "--baseline: b.jsonl: " + words);
  }
  nlohmann::ordered_json question = asked();
  question["inside"] = true;
  EXPECT_EQ(
      message_of(parse({}, question)),
      "--baseline: b.jsonl: was written without --inside: write a new baseline with --inside, "
      "or leave out --inside");
}

TEST(KnownBaseline, RefusesWhatIsNoAnswer) {
  Answer other;
  other.header["format"] = "pelt-bounds";
  EXPECT_TRUE(test::contains(message_of(parse(other)), "format: must be pelt-check"));
  Answer later;
  later.header["version"] = 2;
  EXPECT_TRUE(test::contains(message_of(parse(later)), "version: must be 1"));
  Answer bare;
  bare.header["options"] = 3;
  EXPECT_TRUE(test::contains(message_of(parse(bare)), "options: must be an object"));
  Answer nameless;
  nameless.totals["touches"][0]["a"].erase("copy");
  EXPECT_TRUE(test::contains(message_of(parse(nameless)), "touches[0].a.copy"));
}

TEST(KnownBaseline, NamesAMissingFileOnceAndSaysWhatToGive) {
  const auto missing = CheckBaseline::read("none.jsonl", asked(), scene_of({"knight"}));
  EXPECT_EQ(message_of(missing),
            "--baseline: none.jsonl: there is no such file: give a file written by pelt check "
            "--jsonl");
}

TEST(KnownBaseline, RefusesAFileThatIsCutShort) {
  const std::string text = Answer().text();
  const auto of = [](const std::string& cut) {
    return message_of(CheckBaseline::parse("b.jsonl", cut, asked(), scene_of({"knight"})));
  };
  EXPECT_TRUE(test::contains(of(text.substr(0, text.size() - 9)), "the JSON text"));
  EXPECT_TRUE(test::contains(of(text.substr(0, text.find("\n{\"touches"))),
                             "touches: is missing from the last line"));
  EXPECT_TRUE(test::contains(of(""), "the JSON text"));
}

TEST(KnownBaseline, RefusesAnotherScene) {
  EXPECT_TRUE(test::contains(
      message_of(parse({}, asked(), {"elf", "orc"})),
      "belongs to another scene, with \"knight\", \"thief\" instead of \"elf\", "
      "\"orc\": give the baseline of this scene; if models were renamed, write a new "
      "baseline, or use the earlier names"));
}

TEST(KnownBaseline, NotesWhatElseDiffers) {
  nlohmann::ordered_json question = asked();
  question["frames"] = {0, 20, 2};
  question["ignore"] = json::array({{"cape", "arm"}});
  const Result<CheckBaseline> baseline = parse({}, question, {"knight", "thief", "thief"});
  ASSERT_TRUE(baseline) << baseline.error().message;
  EXPECT_EQ(
      std::vector<std::string>(baseline->notes().begin(), baseline->notes().end()),
      (std::vector<std::string>{
          "frames was [0,10,1] in the baseline and is [0,20,2] now",
          "ignore was [] in the baseline and is [[\"cape\",\"arm\"]] now",
          "instances were 2 of \"knight\", \"thief\" in the baseline and are 3 of \"knight\", "
          "\"thief\" now"}));
}

TEST(KnownBaseline, CountsInstancesOnceWhosePartsAreColliders) {
  Answer answer;
  answer.header["instances"] = {{{"index", 0}, {"model", "knight"}, {"instance", 0}},
                                {{"index", 1}, {"model", "knight"}, {"instance", 0}},
                                {{"index", 2}, {"model", "thief"}, {"instance", 1}}};
  const Result<CheckBaseline> baseline = parse(answer);
  ASSERT_TRUE(baseline) << baseline.error().message;
  EXPECT_TRUE(baseline->notes().empty()) << baseline->notes()[0];
}

TEST(KnownBaseline, FindsNamesThatAreNotText) {
  const Result<CheckBaseline> baseline = parse({}, asked(), {"knight", "thief", "caf\xE9"});
  ASSERT_TRUE(baseline);
  EXPECT_TRUE(test::contains(baseline->notes()[0], "caf\xEF\xBF\xBD"));
}

}  // namespace
}  // namespace pelt::tools::check
