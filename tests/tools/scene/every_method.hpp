#pragma once

/// Queries a scene with every method of the tested program and reads its files once.

#include "tools/pelt/methods/method.hpp"
#include "tools/pelt/scene/frame_contacts.hpp"
#include "tools/pelt/scene/scene_query.hpp"

#include <gtest/gtest.h>

namespace pelt::test {

/// Defined by each test program.
methods::MethodKinds every_method();

struct FramesAnswer {
  std::uint64_t hash = 0;
  std::uint32_t in_contact = 0;  ///< frames

  bool operator==(const FramesAnswer&) const = default;
};

inline FramesAnswer ask_frames(const scenes::Scene& scene, tools::scene::SceneQuery query,
                               std::uint32_t begin, std::uint32_t end) {
  FramesAnswer answer;
  asset::SampleScratch scratch;
  tools::scene::Palettes palettes;
  tools::scene::FrameContacts found;
  tools::scene::ContactHash hash;
  for (std::uint32_t frame = begin; frame < end; ++frame) {
    tools::scene::sample_palettes(scene, frame, scratch, palettes);
    const Result<void> posed = query.set_palettes(palettes);
    EXPECT_TRUE(posed) << posed.error().message;
    query.collide({}, found);
    hash.add(frame, found);
    answer.in_contact += !found.contacts.empty();
  }
  answer.hash = hash.value();
  return answer;
}

/// Expects the same contacts from all methods in frames [begin, end). Returns the number of frames
/// with contacts.
inline std::uint32_t in_contact_by_every_method(const scenes::Scene& scene, std::uint32_t begin,
                                                std::uint32_t end) {
  const auto colliders =
      tools::scene::make_colliders(scene, tools::scene::Granularity::instance, {});
  if (!colliders) return ADD_FAILURE() << colliders.error().message, 0;
  std::vector<FramesAnswer> answers;
  for (const methods::MethodKind& method : every_method()) {
    answers.push_back(ask_frames(scene, tools::scene::SceneQuery(*colliders, method), begin, end));
    EXPECT_EQ(answers.back(), answers.front()) << method.name;
  }
  return answers.front().in_contact;
}

}  // namespace pelt::test
