#pragma once

/// A crowd for tests, with the same instances as single poses.

#include <pelt/crowd.hpp>
#include <pelt/self.hpp>

#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace pelt::test {

inline constexpr std::uint32_t kThreadCounts[] = {1, 2, 3, 8};

/// Instances of several models, as a crowd and as single poses.
struct TestCrowd {
  explicit TestCrowd(std::vector<Shape> shapes) {
    for (const Shape& shape : shapes) models.push_back(*build_model(shape.view()));
  }

  std::uint32_t add(std::uint32_t model, const CollisionMask& mask = {}) {
    const std::uint32_t instance = crowd.add(models[model], mask);
    if (instance == poses.size()) {
      poses.emplace_back(models[model]);
      masks.push_back(mask);
      present.push_back(true);
    } else {
      poses[instance] = Pose(models[model]);
      masks[instance] = mask;
      present[instance] = true;
    }
    return instance;
  }

  void remove(std::uint32_t instance) {
    crowd.remove(instance);
    present[instance] = false;
  }

  void move(std::uint32_t instance, const std::vector<Matrix4>& palette) {
    ASSERT_TRUE(crowd.set_palette(instance, palette));
    ASSERT_TRUE(poses[instance].set_palette(palette));
  }

  bool may_touch(std::uint32_t a, std::uint32_t b) const {
    return (masks[a].member_of & masks[b].collides_with) != 0 &&
           (masks[b].member_of & masks[a].collides_with) != 0;
  }

  /// The contacts of an instance with itself, if asked for.
  void add_self_contacts(std::uint32_t a, const CrowdOptions& options, Scratch& scratch,
                         std::vector<CrowdContact>& all) {
    const SelfFilter* filter = options.self_filter ? options.self_filter(a) : nullptr;
    if (!present[a] || !filter) return;
    std::vector<Contact> contacts;
    pelt::self_collide(poses[a], *filter, scratch, contacts, {options.max_contacts});
    for (const Contact& c : contacts) all.push_back({a, a, c.triangle_a, c.triangle_b});
  }

  /// The contacts of every pair, queried separately.
  std::vector<CrowdContact> expected(const CrowdOptions& options = {}) {
    std::vector<CrowdContact> all;
    Scratch scratch;
    for (std::uint32_t a = 0; a < poses.size(); ++a) {
      add_self_contacts(a, options, scratch, all);
      for (std::uint32_t b = a + 1; b < poses.size(); ++b) {
        if (!present[a] || !present[b] || !may_touch(a, b)) continue;
        if (options.filter && !options.filter(a, b)) continue;
        std::vector<Contact> contacts;
        pelt::collide(poses[a], poses[b], scratch, contacts, {options.max_contacts});
        for (const Contact& c : contacts) all.push_back({a, b, c.triangle_a, c.triangle_b});
      }
    }
    return all;
  }

  std::vector<CrowdContact> contacts(const CrowdOptions& options = {}) {
    std::vector<CrowdContact> found;
    crowd.collide(found, options);
    return found;
  }

  /// One filter per model, each leaving out neighbours in this number of rings.
  std::vector<SelfFilter> self_filters(std::uint32_t rings = 0) const {
    std::vector<SelfFilter> filters;
    for (const SkinnedModel& model : models)
      filters.push_back(*build_self_filter(model, {.rings = rings}));
    return filters;
  }

  std::vector<SkinnedModel> models;
  Crowd crowd;
  std::vector<Pose> poses;
  std::vector<CollisionMask> masks;
  std::vector<bool> present;
};

inline std::vector<CrowdPair> pairs_of(const std::vector<CrowdContact>& contacts) {
  std::vector<CrowdPair> pairs;
  for (const CrowdContact& c : contacts) pairs.push_back({c.instance_a, c.instance_b});
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

/// Limbs of two models and a soup, with space between them.
inline std::vector<Shape> mixed_shapes(Random& random) {
  return {make_limb(12, 8, 3), make_limb(20, 6, 5), make_soup(random, 60, 4, 3, Weights::random)};
}

inline std::vector<Matrix4> palette_for(Random& random, std::uint32_t model, double room) {
  if (model == 2) {
    std::vector<Matrix4> palette = make_palette(random, 4, Motion::affine, 0.3);
    const Vec3 place = random.point(room);
    for (Matrix4& m : palette) m.m[12] += place.x, m.m[13] += place.y, m.m[14] += place.z;
    return palette;
  }
  const Vec3 place = random.point(room);
  return bend_limb(random, model == 0 ? 3 : 5, random.uniform(-0.6, 0.6), place);
}

inline TestCrowd make_mixed_crowd(Random& random, std::uint32_t count, double room) {
  TestCrowd crowd(mixed_shapes(random));
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t model = random.index(3);
    const std::uint32_t instance = crowd.add(model);
    crowd.move(instance, palette_for(random, model, room));
  }
  return crowd;
}

inline std::uint32_t model_of(const TestCrowd& crowd, std::uint32_t instance) {
  const auto found =
      std::find_if(crowd.models.begin(), crowd.models.end(), [&](const SkinnedModel& model) {
        return &model.detail() == &crowd.crowd.model(instance).detail();
      });
  return static_cast<std::uint32_t>(found - crowd.models.begin());
}

}  // namespace pelt::test
