#pragma once

/// A crowd whose instances are also single poses at both ends of a step.

#include "crowd/test_crowd.hpp"

#include <pelt/self.hpp>

#include <map>
#include <span>

namespace pelt::test {

class PosedCrowd {
 public:
  /// Instance i is of model i modulo the number of models. Every instance whose number leaves
  /// `resting - 1` modulo `resting` never moves.
  PosedCrowd(std::span<const SkinnedModel> models, std::uint32_t count, std::uint32_t resting)
      : resting_(resting) {
    for (std::uint32_t i = 0; i < count; ++i) {
      const SkinnedModel& model = models[i % models.size()];
      EXPECT_EQ(crowd.add(model), i);
      from_.emplace_back(model);
      to.emplace_back(model);
    }
    for (const SkinnedModel& model : models)
      filters_.emplace(&model.detail(), *build_self_filter(model, {.rings = 1}));
    offsets_[0].resize(count);
    offsets_[1].resize(count);
  }
  virtual ~PosedCrowd() = default;

  void step() {
    crowd.begin_step();
    end_ = 1 - end_;
    for (std::uint32_t i = 0; i < to.size(); ++i) {
      if (i % resting_ == resting_ - 1) continue;
      std::swap(from_[i], to[i]);
      move(i);
    }
  }

  /// Compares the crowd with all pairs one by one, with one and with three threads.
  void expect_all_pairs() {
    const auto expected = all_contacts();
    const auto expected_moving = all_moving_contacts();
    for (const std::uint32_t threads : {1u, 3u}) {
      std::vector<CrowdContact> found;
      crowd.collide(found, {.threads = threads,
                            .self_filter = [&](std::uint32_t i) { return filter_of(i); }});
      std::sort(found.begin(), found.end());
      ASSERT_EQ(found, expected);
      std::vector<CrowdMovingContact> found_moving;
      crowd.collide(found_moving, {.threads = threads});
      ASSERT_EQ(found_moving, expected_moving);
    }
    contacts += expected.size();
    moving += expected_moving.size();
  }

  Crowd crowd;
  std::vector<Pose> to;                  // poses at the end of the step
  std::size_t contacts = 0, moving = 0;  // compared so far

 protected:
  /// Gives instance i of the crowd and `to[i]` the same pose.
  virtual void move(std::uint32_t i) = 0;

  void set_offsets(std::uint32_t i, std::vector<Vec3> offsets) {
    std::vector<Vec3>& kept = offsets_[end_][i];
    kept = std::move(offsets);
    ASSERT_TRUE(to[i].set_offsets(kept));
    ASSERT_TRUE(crowd.set_offsets(i, kept));
  }

 private:
  const SelfFilter* filter_of(std::uint32_t i) const {
    return &filters_.at(&crowd.model(i).detail());
  }

  std::vector<CrowdContact> all_contacts() {
    std::vector<CrowdContact> all;
    std::vector<Contact> found;
    for (std::uint32_t a = 0; a < to.size(); ++a)
      for (std::uint32_t b = a; b < to.size(); ++b) {
        found.clear();
        if (a == b)
          self_collide(to[a], *filter_of(a), scratch_, found);
        else
          collide(to[a], to[b], scratch_, found);
        for (const Contact& c : found) all.push_back({a, b, c.triangle_a, c.triangle_b});
      }
    return all;
  }

  std::vector<CrowdMovingContact> all_moving_contacts() {
    std::vector<CrowdMovingContact> all;
    std::vector<MovingContact> found;
    for (std::uint32_t a = 0; a < to.size(); ++a)
      for (std::uint32_t b = a + 1; b < to.size(); ++b) {
        found.clear();
        collide({from_[a], to[a]}, {from_[b], to[b]}, scratch_, found);
        for (const MovingContact& contact : found) all.push_back({a, b, contact});
      }
    return all;
  }

  std::uint32_t resting_;
  std::vector<Pose> from_;
  std::map<const detail::Model*, SelfFilter> filters_;
  std::vector<std::vector<Vec3>> offsets_[2];  // of both ends, because poses borrow them
  std::size_t end_ = 0;
  Scratch scratch_;
};

}  // namespace pelt::test
