#include "fuzz/goal.hpp"
#include "fuzz/pair_oracle.hpp"
#include "fuzz/questions.hpp"
#include "support/require.hpp"

#include <pelt/crowd.hpp>

#include <algorithm>

namespace pelt::test {
namespace {

Goal crowd_contacts("Crowd::collide: contacts of more than two instances"),
    crowd_limited("Crowd::collide: max_contacts"), crowd_removed("Crowd::remove");

using detail::TriangleCorners;

/// The palette moved by a vector; a crowd refuses palettes that move vertices too far.
std::vector<Matrix4> moved(std::vector<Matrix4> palette, const Vec3& by) {
  for (Matrix4& joint : palette) {
    joint.m[12] += by.x;
    joint.m[13] += by.y;
    joint.m[14] += by.z;
  }
  return palette;
}

/// A crowd of copies of the two bodies, and the posed triangles of each instance.
class FuzzedCrowd {
 public:
  void add(FuzzBytes& bytes, const FuzzedBody& body) {
    const CollisionMask mask = {1u << bytes.index(2), 3 - bytes.index(3)};
    const std::uint32_t instance = crowd.add(body.pose.model(), mask);
    Pose pose(body.pose.model());
    const std::vector<Matrix4> palette = moved(body.palette, bytes.point());
    const bool is_set = static_cast<bool>(pose.set_morph_weights(body.morph_weights)) &&
                        static_cast<bool>(pose.set_palette(palette));
    if (instance >= triangles_.size()) triangles_.resize(instance + 1), masks_.resize(instance + 1);
    if (!is_set) return crowd.remove(instance);
    require(static_cast<bool>(crowd.set_morph_weights(instance, body.morph_weights)) &&
                static_cast<bool>(crowd.set_palette(instance, palette)),
            "a crowd refuses what a pose accepts");
    masks_[instance] = mask;
    triangles_[instance] = posed(body, pose);
  }

  bool has(std::uint32_t instance) const { return !triangles_[instance].empty(); }
  std::uint32_t end() const { return static_cast<std::uint32_t>(triangles_.size()); }

  void remove(std::uint32_t instance) {
    crowd.remove(instance);
    triangles_[instance].clear();
    crowd_removed.reach();
  }

  std::vector<CrowdContact> expected() const {
    std::vector<CrowdContact> contacts;
    for (std::uint32_t a = 0; a < end(); ++a)
      for (std::uint32_t b = a + 1; b < end(); ++b)
        if (may_touch(masks_[a], masks_[b]))
          for (const Contact& c : intersecting_pairs(triangles_[a], triangles_[b]))
            contacts.push_back({a, b, c.triangle_a, c.triangle_b});
    return contacts;
  }

  Crowd crowd;

 private:
  static bool may_touch(const CollisionMask& a, const CollisionMask& b) {
    return (a.member_of & b.collides_with) != 0 && (b.member_of & a.collides_with) != 0;
  }

  static std::vector<TriangleCorners> posed(const FuzzedBody& body, const Pose& pose) {
    std::vector<Vec3> positions(body.posed.size());
    posed_vertices(pose, positions);
    std::vector<TriangleCorners> triangles;
    for (const auto& [a, b, c] : body.shape.triangles)
      triangles.push_back({positions[a], positions[b], positions[c]});
    return triangles;
  }

  std::vector<std::vector<TriangleCorners>> triangles_;  // empty: removed
  std::vector<CollisionMask> masks_;
};

std::vector<CrowdPair> pairs_of(const std::vector<CrowdContact>& contacts) {
  std::vector<CrowdPair> pairs;
  for (const CrowdContact& c : contacts)
    if (pairs.empty() || pairs.back() != CrowdPair{c.instance_a, c.instance_b})
      pairs.push_back({c.instance_a, c.instance_b});
  return pairs;
}

/// Each pair has as many contacts as it may have, all of them real.
void check_limit(FuzzedCrowd& crowd, std::uint32_t limit,
                 const std::vector<CrowdContact>& expected) {
  std::vector<CrowdContact> some;
  crowd.crowd.collide(some, {.threads = 1, .max_contacts = limit});
  require(std::includes(expected.begin(), expected.end(), some.begin(), some.end()),
          "a contact of a crowd within max_contacts");
  std::size_t count = 0;
  for (const CrowdPair& pair : pairs_of(expected)) {
    const auto contacts = std::count_if(expected.begin(), expected.end(), [&](const auto& c) {
      return CrowdPair{c.instance_a, c.instance_b} == pair;
    });
    count += std::min<std::size_t>(limit, static_cast<std::size_t>(contacts));
  }
  require(some.size() == count, "max_contacts of a crowd");
  crowd_limited.reach(some.size() < expected.size());
}

void check_crowd(FuzzBytes& bytes, FuzzedCrowd& crowd) {
  const std::vector<CrowdContact> expected = crowd.expected();
  const std::uint32_t threads = 1 + bytes.index(2);
  std::vector<CrowdContact> contacts;
  crowd.crowd.collide(contacts, {.threads = threads});
  require(contacts == expected, "the contacts of a crowd");
  std::vector<CrowdPair> pairs;
  crowd.crowd.intersecting_pairs(pairs, {.threads = threads});
  require(pairs == pairs_of(expected), "the pairs of a crowd");
  check_limit(crowd, 1 + bytes.index(3), expected);
  crowd_contacts.reach(pairs.size() > 1);
}

}  // namespace

void ask_crowd(Question& q) {
  FuzzedCrowd crowd;
  const std::uint32_t count = 2 + q.bytes.index(5);
  for (std::uint32_t i = 0; i < count; ++i) crowd.add(q.bytes, q.bytes.index(2) == 0 ? q.a : q.b);
  if (crowd.end() == 0) return;
  check_crowd(q.bytes, crowd);
  if (const std::uint32_t instance = q.bytes.index(crowd.end()); crowd.has(instance)) {
    crowd.remove(instance);
    crowd.add(q.bytes, q.b);
    check_crowd(q.bytes, crowd);
  }
}

}  // namespace pelt::test
