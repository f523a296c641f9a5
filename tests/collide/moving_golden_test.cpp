/// Moving contacts of generated characters, whose bits are the same everywhere: contacts, times and
/// features. A hash here changes only if the characters or the definitions change.

#include <pelt/self.hpp>

#include "base/bits.hpp"
#include "base/hash.hpp"
#include "scenes/creature.hpp"
#include "support/instruction_sets.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace pelt::test {
namespace {

constexpr int kSteps = 6;

/// A creature in frames of its first clip, at a place.
struct Actor {
  Actor(const scenes::CreatureOptions& options, float x)
      : asset(*scenes::make_creature(options)),
        from(*build_model(asset.mesh())),
        to(from.model()),
        filter(*build_self_filter(from.model())),
        place(x) {}

  void step(int number) {
    pose(from, number);
    pose(to, number + 1);
  }

  Motion motion() { return {from, to}; }

  asset::Asset asset;
  Pose from, to;
  SelfFilter filter;
  float place;

 private:
  void pose(Pose& at, int frame) {
    asset::SampleScratch samples;
    std::vector<Matrix4> palette(asset.joints.size());
    sample_palette(asset, &asset.clips[0], 0.1f * static_cast<float>(frame), {}, samples, palette);
    for (Matrix4& m : palette) m.m[12] += place;
    ASSERT_TRUE(at.set_palette(palette));
  }
};

class HashOfContacts {
 public:
  void add(const std::vector<MovingContact>& contacts) {
    for (const auto& [pair, time, at_start, a, b] : contacts) {
      for (const std::uint32_t value : {pair.triangle_a, pair.triangle_b}) hash_.add_u32(value);
      hash_.add_u32(detail::bits_as<std::uint32_t>(time));
      hash_.add_u32(at_start);
      for (const Feature& f : {a, b})
        hash_.add_u32(static_cast<std::uint32_t>(f.kind) << 8 | f.number);
    }
    contacts_ += contacts.size();
  }

  std::uint64_t value() const { return hash_.value(); }
  std::size_t contacts() const { return contacts_; }

 private:
  detail::Fnv1a64 hash_;
  std::size_t contacts_ = 0;
};

TEST(MovingGolden, OfTwoCreaturesIsTheSameOnEveryTarget) {
  Actor man(scenes::kMan, 0), dwarf(scenes::kDwarf, 0.35f);
  on_each_instruction_set([&](InstructionSet) {
    Scratch scratch;
    HashOfContacts hash;
    for (int number = 0; number < kSteps; ++number) {
      man.step(number);
      dwarf.step(number);
      std::vector<MovingContact> contacts;
      collide(man.motion(), dwarf.motion(), scratch, contacts);
      hash.add(contacts);
    }
    EXPECT_EQ(hash.contacts(), 15775u);
    EXPECT_EQ(hash.value(), 0xeeb548687d68d0b4);
  });
}

TEST(MovingGolden, OfACreatureWithItselfIsTheSameOnEveryTarget) {
  Actor man(scenes::kMan, 0);
  on_each_instruction_set([&](InstructionSet) {
    Scratch scratch;
    HashOfContacts hash;
    for (int number = 0; number < kSteps; ++number) {
      man.step(number);
      std::vector<MovingContact> contacts;
      self_collide(man.motion(), man.filter, scratch, contacts);
      hash.add(contacts);
    }
    EXPECT_EQ(hash.contacts(), 28u);
    EXPECT_EQ(hash.value(), 0xf4a4c1d875784c31);
  });
}

}  // namespace
}  // namespace pelt::test
