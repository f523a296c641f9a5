#include "scenes/creature.hpp"

#include <pelt/pelt.hpp>

#include "base/hash.hpp"
#include "support/sanitizers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <set>

namespace pelt::scenes {
namespace {

using asset::Asset;

constexpr std::uint32_t kLargest = test::kHasSanitizer ? 200000 : 1000000;

Asset make(const CreatureOptions& options) {
  Result<Asset> asset = make_creature(options);
  EXPECT_TRUE(asset) << (asset ? "" : asset.error().message);
  return asset ? std::move(*asset) : Asset();
}

struct Vector {
  double x, y, z;
};
Vector operator-(const Vec3& a, const Vec3& b) {
  return {double{a.x} - b.x, double{a.y} - b.y, double{a.z} - b.z};
}
Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// Every directed edge and its reverse occur once: closed, 2-manifold along edges, oriented.
void expect_closed(const Asset& asset) {
  std::vector<std::uint64_t> edges, reversed;
  for (const Triangle& t : asset.triangles) {
    for (int i = 0; i < 3; ++i) {
      const std::uint64_t a = t[i], b = t[(i + 1) % 3];
      edges.push_back(a << 32 | b);
      reversed.push_back(b << 32 | a);
    }
  }
  std::sort(edges.begin(), edges.end());
  std::sort(reversed.begin(), reversed.end());
  EXPECT_EQ(std::adjacent_find(edges.begin(), edges.end()), edges.end());
  EXPECT_EQ(edges, reversed);
}

std::uint32_t root_of(std::vector<std::uint32_t>& parent, std::uint32_t v) {
  while (parent[v] != v) v = parent[v] = parent[parent[v]];
  return v;
}

/// Connected, with the Euler characteristic of a ball: no handle, no hole, no vertex where two
/// sheets meet.
void expect_ball(const Asset& asset) {
  const std::uint32_t vertex_count = static_cast<std::uint32_t>(asset.rest_positions.size());
  std::vector<std::uint32_t> parent(vertex_count);
  for (std::uint32_t v = 0; v < vertex_count; ++v) parent[v] = v;
  for (const Triangle& t : asset.triangles) {
    parent[root_of(parent, t[0])] = root_of(parent, t[1]);
    parent[root_of(parent, t[1])] = root_of(parent, t[2]);
  }
  std::uint32_t components = 0;
  for (std::uint32_t v = 0; v < vertex_count; ++v) components += parent[v] == v;
  EXPECT_EQ(components, 1u);
  EXPECT_EQ(2 * vertex_count, asset.triangles.size() + 4);
}

double signed_volume(const Asset& asset) {
  double six_volumes = 0;
  for (const Triangle& t : asset.triangles) {
    const auto& p = asset.rest_positions;
    six_volumes += dot(p[t[0]] - Vec3(), cross(p[t[1]] - Vec3(), p[t[2]] - Vec3()));
  }
  return six_volumes / 6;
}

/// 1 for equilateral triangles, 0 for collapsed ones.
std::vector<double> shapes(const Asset& asset) {
  std::vector<double> result;
  for (const Triangle& t : asset.triangles) {
    const auto& p = asset.rest_positions;
    const Vector u = p[t[1]] - p[t[0]], v = p[t[2]] - p[t[0]], w = p[t[2]] - p[t[1]];
    const Vector n = cross(u, v);
    const double squares = dot(u, u) + dot(v, v) + dot(w, w);
    result.push_back(squares > 0 ? 2 * std::sqrt(3.0) * std::sqrt(dot(n, n)) / squares : 0);
  }
  return result;
}

void expect_sound_surface(const Asset& asset) {
  expect_closed(asset);
  expect_ball(asset);
  EXPECT_GT(signed_volume(asset), 0.08);
  EXPECT_LT(signed_volume(asset), 0.5);
  const std::vector<double> all = shapes(asset);
  double sum = 0;
  for (double shape : all) sum += shape;
  EXPECT_GT(*std::min_element(all.begin(), all.end()), 0.1);
  EXPECT_GT(sum / static_cast<double>(all.size()), 0.9);
}

void expect_sound_weights(const Asset& asset) {
  ASSERT_LE(asset.influences_per_vertex, 4u);
  const std::size_t k = asset.influences_per_vertex;
  ASSERT_EQ(asset.weights.size(), k * asset.rest_positions.size());
  ASSERT_EQ(asset.joint_indices.size(), asset.weights.size());
  std::set<std::uint16_t> used;
  for (std::size_t v = 0; v < asset.rest_positions.size(); ++v) {
    double sum = 0;
    std::set<std::uint16_t> joints;
    for (std::size_t i = k * v; i < k * (v + 1); ++i) {
      sum += asset.weights[i];
      ASSERT_GE(asset.weights[i], 0);
      ASSERT_LT(asset.joint_indices[i], asset.joints.size());
      if (asset.weights[i] == 0) continue;
      ASSERT_TRUE(joints.insert(asset.joint_indices[i]).second) << "joint twice, vertex " << v;
      used.insert(asset.joint_indices[i]);
    }
    ASSERT_NEAR(sum, 1, 1e-6) << v;
  }
  // With few triangles, the outermost joint of a finger may have no vertex.
  EXPECT_GE(used.size() + 4, asset.joints.size());
}

TEST(Creature, PaperSizesAreExactAndSound) {
  for (const CreatureOptions& options : {kDwarf, kMan, kCreature}) {
    SCOPED_TRACE(options.triangles);
    const Asset asset = make(options);
    EXPECT_EQ(asset.triangles.size(), options.triangles);
    EXPECT_EQ(asset.joints.size(), options.joints);
    expect_sound_surface(asset);
    expect_sound_weights(asset);
  }
  EXPECT_EQ(kDwarf.triangles, 1664u);
  EXPECT_EQ(kDwarf.joints, 45u);
  EXPECT_EQ(kMan.triangles, 8270u);
  EXPECT_EQ(kMan.joints, 27u);
  EXPECT_EQ(kCreature.triangles, 13590u);
  EXPECT_EQ(kCreature.joints, 56u);
}

TEST(Creature, EverySizeIsMetAndSound) {
  const std::array<CreatureOptions, 5> sweep = {
      {{1000, 20, 7}, {1001, 21, 8}, {4999, 64, 9}, {20000, 33, 10}, {100000, 50, 11}}};
  for (const CreatureOptions& options : sweep) {
    SCOPED_TRACE(options.triangles);
    const Asset asset = make(options);
    EXPECT_EQ(asset.triangles.size(), options.triangles / 2 * 2);
    EXPECT_EQ(asset.joints.size(), options.joints);
    expect_sound_surface(asset);
    expect_sound_weights(asset);
  }
}

TEST(Creature, LargestSizeIsMetAndSound) {
  const Asset asset = make({kLargest, 56, 1});
  EXPECT_EQ(asset.triangles.size(), kLargest);
  expect_sound_surface(asset);
}

TEST(Creature, EverySeedStandsOnTheGroundAndIsAsTallAsPromised) {
  for (std::uint32_t seed : {0u, 5u, 12u, 2024u, 0xFFFFFFFFu}) {
    SCOPED_TRACE(seed);
    const Asset asset = make({3000, 30, seed});
    expect_sound_surface(asset);
    Vec3 low = asset.rest_positions[0], high = low;
    for (const Vec3& p : asset.rest_positions) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    EXPECT_NEAR(low.y, 0, 0.003);
    EXPECT_NEAR(high.y, 1.8, 0.03);
    EXPECT_NEAR(low.x + high.x, 0, 0.03);  // symmetric about x = 0
    EXPECT_GT(high.x - low.x, 0.7);
  }
}

TEST(Creature, ModelBuildsWithoutRemarks) {
  const Asset asset = make(kDwarf);
  const Result<SkinnedModel> model = build_model(asset.mesh());
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model->report().renormalised_vertices, 0u);
  EXPECT_EQ(model->report().merged_influences, 0u);
  EXPECT_EQ(model->report().degenerate_triangles, 0u);
}

TEST(Creature, OnePartCoversAllTriangles) {
  const Asset asset = make({1000, 20, 1});
  ASSERT_EQ(asset.parts.size(), 1u);
  EXPECT_EQ(asset.parts[0].first_triangle, 0u);
  EXPECT_EQ(asset.parts[0].triangle_count, 1000u);
  EXPECT_TRUE(asset.parts[0].skinned);
}

TEST(Creature, RefusesOptionsOutOfRange) {
  const auto message = [](const CreatureOptions& options) {
    const Result<Asset> asset = make_creature(options);
    return asset ? std::string() : asset.error().message;
  };
  EXPECT_EQ(message({999, 56, 1}), "creature: triangles is 999, expected 1000 to 1000000");
  EXPECT_EQ(message({1000001, 56, 1}), "creature: triangles is 1000001, expected 1000 to 1000000");
  EXPECT_EQ(message({2000, 19, 1}), "creature: joints is 19, expected 20 to 64");
  EXPECT_EQ(message({2000, 65, 1}), "creature: joints is 65, expected 20 to 64");
}

TEST(Creature, SeedsDiffer) {
  const Asset a = make({1000, 20, 1}), b = make({1000, 20, 2});
  EXPECT_NE(a.rest_positions, b.rest_positions);
}

std::uint64_t hash_of(const Asset& asset) {
  detail::Fnv1a64 hash;
  const auto add = [&](float number) { hash.add_u32(std::bit_cast<std::uint32_t>(number)); };
  for (const Vec3& p : asset.rest_positions) {
    add(p.x);
    add(p.y);
    add(p.z);
  }
  for (const Triangle& t : asset.triangles) {
    for (std::uint32_t v : t) hash.add_u32(v);
  }
  for (std::uint16_t joint : asset.joint_indices) hash.add_u32(joint);
  for (float weight : asset.weights) add(weight);
  for (const asset::Node& node : asset.nodes) {
    for (float number : node.local.translation) add(number);
  }
  for (const asset::Clip& clip : asset.clips) {
    add(clip.duration);
    for (const asset::Channel& channel : clip.channels) {
      hash.add_u32(channel.node);
      for (float time : channel.times) add(time);
      for (float value : channel.values) add(value);
    }
  }
  return hash.value();
}

// The bits do not depend on the compiler or the optimisation level. Changing the creature changes
// these numbers, and the hashes of all its contacts.
TEST(Creature, SameBitsEverywhere) {
  EXPECT_EQ(hash_of(make(kDwarf)), 0x87a7f5bd399fab9du);
  EXPECT_EQ(hash_of(make(kMan)), 0xefaa38ac993b98c6u);
  EXPECT_EQ(hash_of(make(kCreature)), 0x204c9186d5172927u);
}

/// Plays a clip of a creature.
class Player {
 public:
  Player(const Asset& asset, const char* clip)
      : asset_(asset),
        clip_(*asset.find_clip(clip)),
        pose_(*build_model(asset.mesh())),
        palette_(asset.joints.size()) {}

  std::vector<Matrix4> palette_at(double phase) {
    const float seconds = static_cast<float>(phase * clip_.duration);
    asset::sample_palette(asset_, &clip_, seconds, {}, scratch_, palette_);
    return palette_;
  }

  std::vector<Vec3> vertices_at(double phase) {
    EXPECT_TRUE(pose_.set_palette(palette_at(phase)));
    std::vector<Vec3> vertices(asset_.rest_positions.size());
    posed_vertices(pose_, vertices);
    return vertices;
  }

  double duration() const { return clip_.duration; }

 private:
  const Asset& asset_;
  const asset::Clip& clip_;
  Pose pose_;
  asset::SampleScratch scratch_;
  std::vector<Matrix4> palette_;
};

TEST(CreatureClips, AreLoops) {
  const Asset asset = make(kDwarf);
  ASSERT_EQ(asset.clips.size(), 2u);
  for (const char* clip : {"walk", "idle"}) {
    ASSERT_NE(asset.find_clip(clip), nullptr);
    Player player(asset, clip);
    EXPECT_EQ(player.palette_at(0), player.palette_at(1));
    EXPECT_NE(player.palette_at(0), player.palette_at(0.5));
  }
}

TEST(CreatureClips, DefaultPoseIsTheRestPose) {
  const Asset asset = make({1000, 64, 1});
  asset::SampleScratch scratch;
  std::vector<Matrix4> palette(asset.joints.size());
  asset::sample_palette(asset, nullptr, 0, {}, scratch, palette);
  for (const Matrix4& matrix : palette) {
    for (int i = 0; i < 16; ++i) EXPECT_NEAR(matrix.m[i], Matrix4().m[i], 1e-6);
  }
}

double lowest(const std::vector<Vec3>& vertices) {
  double y = vertices[0].y;
  for (const Vec3& v : vertices) y = std::min(y, double{v.y});
  return y;
}

// At least one foot is on the ground in every frame, and no foot is below it.
TEST(CreatureClips, FeetTouchTheGround) {
  for (const CreatureOptions& options :
       {CreatureOptions{6000, 20, 3}, CreatureOptions{6000, 64, 6}}) {
    const Asset asset = make(options);
    for (const char* clip : {"walk", "idle"}) {
      Player player(asset, clip);
      for (int frame = 0; frame < 48; ++frame) {
        EXPECT_NEAR(lowest(player.vertices_at(frame / 48.0)), 0, 0.004) << clip << " " << frame;
      }
    }
  }
}

// Some of the vertices on the ground move backwards exactly as the ground does under a creature
// that walks at kWalkSpeed.
TEST(CreatureClips, FeetDoNotSlide) {
  constexpr int kFrames = 96;
  const Asset asset = make({6000, 40, 2});
  Player player(asset, "walk");
  const double way = kWalkSpeed * player.duration() / kFrames;
  std::vector<Vec3> before = player.vertices_at(0);
  for (int frame = 1; frame <= kFrames; ++frame) {
    const std::vector<Vec3> now = player.vertices_at(frame / double{kFrames});
    double least_slide = 1;
    for (std::size_t v = 0; v < now.size(); ++v) {
      if (now[v].y > 0.004 || before[v].y > 0.004) continue;
      const double x = double{now[v].x} - before[v].x, z = double{now[v].z} - before[v].z + way;
      least_slide = std::min(least_slide, std::sqrt(x * x + z * z));
    }
    EXPECT_LT(least_slide, 0.0005) << frame;
    before = now;
  }
}

// The skin does not tear: edges roughly keep their length, and the belly stays in place.
TEST(CreatureClips, SkinStaysTogether) {
  for (const CreatureOptions& options : {kDwarf, kMan, kCreature}) {
    const Asset asset = make(options);
    for (const char* clip : {"walk", "idle"}) {
      Player player(asset, clip);
      double longest = 0;
      for (int frame = 0; frame < 24; ++frame) {
        const std::vector<Vec3> posed = player.vertices_at(frame / 24.0);
        for (const Triangle& t : asset.triangles) {
          for (int i = 0; i < 3; ++i) {
            const std::uint32_t a = t[i], b = t[(i + 1) % 3];
            const Vector rest = asset.rest_positions[b] - asset.rest_positions[a];
            const Vector now = posed[b] - posed[a];
            longest = std::max(longest, std::sqrt(dot(now, now) / dot(rest, rest)));
          }
        }
      }
      EXPECT_LT(longest, 3.5) << options.triangles << " " << clip;
      EXPECT_GT(longest, 1.05);
    }
  }
}

TEST(CreatureClips, WalkMovesArmsAndLegsAcross) {
  const Asset asset = make({1000, 20, 1});
  Player player(asset, "walk");
  std::map<std::string, std::uint32_t> joints;
  for (std::uint32_t j = 0; j < asset.joints.size(); ++j) joints[asset.joint_name(j)] = j;
  const auto place = [&](const std::string& name, double phase) {
    const std::uint32_t j = joints.at(name);
    const Matrix4& bind = asset.joints[j].inverse_bind;
    const Matrix4 m = player.palette_at(phase)[j];
    return m.m[14] - m.m[2] * bind.m[12] - m.m[6] * bind.m[13] - m.m[10] * bind.m[14];
  };
  EXPECT_GT(place("foot_l", 0), place("foot_r", 0) + 0.2);
  EXPECT_LT(place("hand_l", 0), place("hand_r", 0) - 0.1);
  EXPECT_LT(place("foot_l", 0.5), place("foot_r", 0.5) - 0.2);
}

}  // namespace
}  // namespace pelt::scenes
