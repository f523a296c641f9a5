/// Bullet's GImpact: a binary tree of boxes with 16 bits per coordinate, refitted.
///
/// The box set is used like in GImpact's mesh shapes, but reads posed vertices directly. A refit
/// keeps the coordinate range of the build; triangles that leave this range no longer collide,
/// without any error. Each body therefore has a frame that follows the middle of its posed box. The
/// tree is built over the mesh at twice its size, and is built again if the body outgrows this.
/// Rounding to 16 bits may shrink boxes, so they are enlarged by a margin of one step, which also
/// covers the rounding of the frame.
///
/// Its candidates are tested by Pelt's exact predicate or, as a separate peer, by Bullet's triangle
/// test, which also accepts pairs within a margin. Neither can be stopped before all candidates are
/// found.
#include "evaluation/peers/adapters.hpp"
#include "evaluation/peers/candidates.hpp"

#include <BulletCollision/Gimpact/btGImpactQuantizedBvh.h>
#include <BulletCollision/Gimpact/btTriangleShapeEx.h>

#include <algorithm>
#include <array>
#include <string>

namespace pelt::peers {
namespace {

btVector3 to_bullet(const Vec3& p) { return {p.x, p.y, p.z}; }

btVector3 min(btVector3 a, const btVector3& b) {
  a.setMin(b);
  return a;
}

btVector3 max(btVector3 a, const btVector3& b) {
  a.setMax(b);
  return a;
}

btAABB box_of(std::span<const Vec3> positions) {
  btAABB box;
  box.invalidate();
  for (const Vec3& p : positions) {
    const btVector3 point = to_bullet(p);
    box.m_min.setMin(point);
    box.m_max.setMax(point);
  }
  return box;
}

btScalar largest(const btVector3& v) { return v.absolute()[v.absolute().maxAxis()]; }

/// The triangles of a body in the frame of the body.
class Triangles final : public btPrimitiveManagerBase {
 public:
  explicit Triangles(const PosedBody& body) : body_(body) {}

  bool is_trimesh() const override { return true; }
  int get_primitive_count() const override { return static_cast<int>(body_.triangles.size()); }

  void get_primitive_box(int index, btAABB& box) const override {
    const auto [a, b, c] = corners(index);
    box.m_min = min(min(a, b), c) * size_ - margin_;
    box.m_max = max(max(a, b), c) * size_ + margin_;
  }

  void get_primitive_triangle(int index, btPrimitiveTriangle& triangle) const override {
    const std::array<btVector3, 3> local = corners(index);
    std::copy(local.begin(), local.end(), triangle.m_vertices);
    triangle.m_margin = margin_.x();
  }

  /// Sets the origin of the frame, the factor by which boxes are scaled, and the margin that is
  /// added to scaled boxes.
  void set_frame(const btVector3& origin, btScalar size, btScalar margin) {
    origin_ = origin;
    size_ = size;
    margin_ = {margin, margin, margin};
  }

  const btVector3& origin() const { return origin_; }

 private:
  std::array<btVector3, 3> corners(int index) const {
    const Triangle& v = body_.triangles[index];
    return {to_bullet(body_.positions[v[0]]) - origin_, to_bullet(body_.positions[v[1]]) - origin_,
            to_bullet(body_.positions[v[2]]) - origin_};
  }

  const PosedBody& body_;
  btVector3 origin_ = {0, 0, 0};
  btScalar size_ = 1;
  btVector3 margin_ = {0, 0, 0};
};

class Body {
 public:
  Body(std::span<const Triangle> triangles, std::span<const Vec3> rest)
      : mesh_(triangles, rest), triangles_(mesh_), boxes_(&triangles_) {
    pose();
  }

  void update(std::span<const Vec3> positions) {
    mesh_.positions = positions;
    pose();
  }

  const PosedBody& mesh() const { return mesh_; }
  const Triangles& triangles() const { return triangles_; }
  const btGImpactQuantizedBvh& boxes() const { return boxes_; }
  btTransform placement() const {
    return btTransform(btMatrix3x3::getIdentity(), triangles_.origin());
  }

 private:
  void pose() {
    const btAABB box = box_of(mesh_.positions);
    const btVector3 middle = (box.m_min + box.m_max) * 0.5f, half = box.m_max - middle;
    if (outgrows(half)) build(middle, half);
    triangles_.set_frame(middle, 1, margin_around(middle));
    boxes_.update();
  }

  bool outgrows(const btVector3& half) const {
    return half.x() > room_.x() || half.y() > room_.y() || half.z() > room_.z();
  }

  void build(const btVector3& middle, const btVector3& half) {
    constexpr btScalar kSize = 2;
    room_ = half * kSize;
    triangles_.set_frame(middle, kSize, 0);
    boxes_.buildSet();
  }

  /// One step of the 16 bits, which GImpact spreads over one unit more on each side, plus the
  /// rounding to 24 bits at this distance from the origin.
  btScalar margin_around(const btVector3& middle) const {
    return 2 * (largest(room_) + 1) / 65535 + largest(middle) * 4e-7f;
  }

  PosedBody mesh_;
  Triangles triangles_;
  btGImpactQuantizedBvh boxes_;
  btVector3 room_ = {-1, -1, -1};
};

/// Tests the candidates with Bullet's own triangle test.
QueryStats keep_theirs(const btPairSet& pairs, const Body& a, const Body& b,
                       std::vector<Contact>& contacts, std::uint32_t max_contacts) {
  QueryStats work;
  std::uint32_t found = 0;
  for (int i = 0; i < pairs.size() && found < max_contacts; ++i) {
    ++work.triangle_pairs;
    btPrimitiveTriangle triangle_a, triangle_b;
    a.triangles().get_primitive_triangle(pairs[i].m_index1, triangle_a);
    b.triangles().get_primitive_triangle(pairs[i].m_index2, triangle_b);
    triangle_a.applyTransform(a.placement());
    triangle_b.applyTransform(b.placement());
    triangle_a.buildTriPlane();
    triangle_b.buildTriPlane();
    GIM_TRIANGLE_CONTACT contact;
    if (!triangle_a.overlap_test_conservative(triangle_b) ||
        !triangle_a.find_triangle_collision_clip_method(triangle_b, contact))
      continue;
    contacts.push_back({static_cast<std::uint32_t>(pairs[i].m_index1),
                        static_cast<std::uint32_t>(pairs[i].m_index2)});
    ++found;
  }
  work.cut_short = found == max_contacts;
  return work;
}

/// Tests the candidates with Pelt's predicate.
QueryStats keep_exact(const btPairSet& pairs, const Body& a, const Body& b,
                      std::vector<Contact>& contacts, std::uint32_t max_contacts) {
  Candidates candidates(a.mesh(), b.mesh(), contacts, max_contacts);
  for (int i = 0; i < pairs.size() && candidates.wants_more(); ++i)
    candidates.add(static_cast<std::uint32_t>(pairs[i].m_index1),
                   static_cast<std::uint32_t>(pairs[i].m_index2));
  return candidates.work();
}

using Keep = QueryStats (*)(const btPairSet&, const Body&, const Body&, std::vector<Contact>&,
                            std::uint32_t);

class BulletMethod final : public MethodOfBodies<Body> {
 public:
  explicit BulletMethod(Keep keep) : keep_(keep) {}

  QueryStats collide(std::uint32_t a, std::uint32_t b, std::vector<Contact>& contacts,
                     std::uint32_t max_contacts) override {
    const Body &body_a = *bodies_[a], &body_b = *bodies_[b];
    pairs_.resizeNoInitialize(0);
    btGImpactQuantizedBvh::find_collision(&body_a.boxes(), body_a.placement(), &body_b.boxes(),
                                          body_b.placement(), pairs_);
    return keep_(pairs_, body_a, body_b, contacts, max_contacts);
  }

 private:
  Keep keep_;
  btPairSet pairs_;
};

}  // namespace

std::unique_ptr<rivals::PosedMeshMethod> make_bullet() {
  return std::make_unique<BulletMethod>(keep_exact);
}

std::unique_ptr<rivals::PosedMeshMethod> make_bullet_own() {
  return std::make_unique<BulletMethod>(keep_theirs);
}

std::string bullet_version() {
  const int version = btGetVersion();
  return std::to_string(version / 100) + '.' + std::to_string(version % 100);
}

}  // namespace pelt::peers
