#include "scenes/name_index.hpp"

#include <gtest/gtest.h>

namespace pelt::scenes {
namespace {

using Numbers = std::vector<std::uint32_t>;

/// Parts "part 0" ..., then joints "hips" and "part 3".
Character character_of(std::uint32_t parts) {
  Character character;
  character.name = "knight";
  for (std::uint32_t p = 0; p < parts; ++p)
    character.asset.parts.push_back({"part " + std::to_string(p), "", "", p, 1, true});
  character.asset.joints.resize(2);
  character.asset.nodes.resize(2);
  character.asset.joints[1].node = 1;
  character.asset.nodes[0].name = "hips";
  character.asset.nodes[1].name = "part 3";
  return character;
}

TEST(NameIndex, NumbersPartsThenJoints) {
  const NameIndex index(character_of(5));
  EXPECT_EQ(index.part_count(), 5u);
  EXPECT_EQ(index.find("part 3"), (Numbers{3, 6}));
  EXPECT_EQ(index.find("knight/part 3"), (Numbers{3, 6}));
  EXPECT_EQ(index.find("hips"), Numbers{5});
  EXPECT_EQ(index.find("*"), (Numbers{0, 1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(index.find("k*t/h*"), Numbers{5});
  EXPECT_EQ(index.find("*2"), Numbers{2});
  EXPECT_EQ(index.find("part"), Numbers{});
  EXPECT_EQ(index.find("thief/hips"), Numbers{});
  EXPECT_EQ(index.find(""), Numbers{});
}

TEST(NameIndex, ComparesOnlyNamesThatStartLikeThePattern) {
  const NameIndex index(character_of(10'000));
  EXPECT_EQ(index.candidates("part 7"), 1u);
  EXPECT_EQ(index.candidates("knight/part 7"), 1u);
  EXPECT_EQ(index.candidates("part 77*"), 1u + 10u + 100u);
  EXPECT_EQ(index.candidates("nothing"), 0u);
  EXPECT_EQ(index.candidates("nothing*"), 0u);
  EXPECT_EQ(index.candidates("*7"), 2u * 10'002u);
}

}  // namespace
}  // namespace pelt::scenes
