#include "pose/every_query.hpp"

#include "base/hash.hpp"
#include "support/random.hpp"

#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <type_traits>
#include <vector>

namespace pelt::test {
namespace {

class Asker {
 public:
  Asker(Stage& stage, Scratch& scratch)
      : a_(stage.a),
        b_(stage.b),
        move_a_{stage.a_from, stage.a},
        move_b_{stage.b_from, stage.b},
        scratch_(scratch) {}

  Answers run() {
    ask_contacts();
    ask_self();
    ask_distances();
    ask_inside();
    ask_bounds();
    ask_rays();
    ask_points();
    ask_regions();
    ask_field();
    ask_motion();
    ask_searches();
    for (const auto& [query, hash] : hashes_) answers_.hashes[query] = hash.value();
    return answers_;
  }

 private:
  template <typename... Numbers>
  requires(std::is_arithmetic_v<Numbers>&&...) void add(const char* query,
                                                        const Numbers&... numbers) {
    const auto add_one = [&](const auto& number) {
      std::byte bytes[sizeof number];
      std::memcpy(bytes, &number, sizeof number);
      hashes_[query].add_bytes(bytes);
    };
    (add_one(numbers), ...);
  }

  void add(const char* query, const Vec3& v) { add(query, v.x, v.y, v.z); }
  void add(const char* query, const Box& box) { add(query, box.low), add(query, box.high); }
  void add(const char* query, const SurfacePoint& point) {
    add(query, point.triangle);
    add(query, point.position);
  }
  void found(const char* query, std::uint64_t count) { answers_.found[query] += count; }

  void add(const char* query, const std::vector<Contact>& contacts) {
    found(query, contacts.size());
    for (const Contact& c : contacts) add(query, c.triangle_a, c.triangle_b);
  }

  void add(const char* query, const MovingContact& c) {
    add(query, c.contact.triangle_a, c.contact.triangle_b, c.time, c.at_start);
    if (!c.at_start) add(query, c.a.kind == c.b.kind, c.a.number, c.b.number);
  }

  void add(const char* query, const std::vector<MovingContact>& contacts) {
    found(query, contacts.size());
    for (const MovingContact& c : contacts) add(query, c);
  }

  void ask_contacts() {
    std::vector<Contact> contacts;
    collide(a_, b_, scratch_, contacts);
    add("collide", contacts);
    add("intersects", intersects(a_, b_, scratch_).answer);
    ContactGeometry geometry;
    describe_contacts(a_, b_, contacts, scratch_, geometry);
    add_geometry("describe", geometry);
  }

  void add_geometry(const char* query, const ContactGeometry& geometry) {
    found(query, geometry.traces.size());
    for (const ContactTrace& t : geometry.traces) {
      add(query, t.from), add(query, t.to), add(query, t.normal);
      add(query, t.depth);
    }
    for (const ContactPatch& p : geometry.patches) add(query, p.length, p.depth, p.joint_a);
  }

  void ask_self() {
    const SelfFilter filter = *build_self_filter(a_.model());
    std::vector<Contact> contacts;
    self_collide(a_, filter, scratch_, contacts);
    add("self", contacts);
    ContactGeometry geometry;
    describe_contacts(a_, contacts, scratch_, geometry);
    add_geometry("describe self", geometry);
    std::vector<MovingContact> moving;
    self_collide(move_a_, filter, scratch_, moving);
    add("self motion", moving);
    SelfTracker tracker(filter);
    for (Pose* pose : {&move_a_.from, &move_a_.to, &move_a_.to}) {
      contacts.clear();
      self_collide(*pose, tracker, scratch_, contacts);
      add("self tracker", contacts);
    }
  }

  void ask_distances() {
    Distance nearest;
    distance(a_, b_, scratch_, nearest);
    found("distance", nearest.distance > 0);
    add("distance", nearest.distance);
    add("distance", nearest.a), add("distance", nearest.b);
    std::vector<Contact> near;
    clearance(a_, b_, 0.05, scratch_, near);
    found("clearance", near.size());
    for (const Contact& pair : near) add("clearance", pair.triangle_a, pair.triangle_b);
    add("is_within", is_within(a_, b_, 0.05, scratch_).answer);
  }

  void ask_inside() {
    if (!a_.model().surface().is_closed() || !b_.model().surface().is_closed()) return;
    Penetration deepest;
    deepest_vertex(a_, b_, scratch_, deepest);
    found("deepest", static_cast<bool>(deepest));
    add("deepest", deepest.vertex, deepest.depth);
    Containment contained = {};
    containment(a_, b_, scratch_, contained);
    add("containment", static_cast<int>(contained));
    for (int i = 0; i < 40; ++i) {
      Vec3 point = random_.point(0.15);
      point.y = random_.uniformf(0, 1);  // as the limbs
      PointSide side = PointSide::outside;
      side_of(b_, point, scratch_, side);
      found("side", side == PointSide::inside);
      add("side", static_cast<int>(side));
    }
  }

  void ask_bounds() {
    Bounds box;
    exact_bounds(a_, box);
    add("bounds", box.box);
    const VertexGroups groups = group_by_joint(a_.model());
    for (std::uint32_t g = 0; g < groups.count(); ++g) {
      Box exact, bound;
      exact_group_bounds(a_, groups, g, exact);
      group_bounds(a_, groups, g, bound);
      add("groups", exact);
      found("groups", bound.low.x <= exact.low.x && exact.high.y <= bound.high.y);
    }
    for (int i = 0; i < 5; ++i) {
      FarthestVertex farthest;
      farthest_vertex(a_, random_.point(1), farthest);
      add("farthest", farthest.position);
    }
  }

  void ask_rays() {
    for (int i = 0; i < 20; ++i) {
      const Ray ray = segment(random_.point(2), random_.point(0.5));
      RayHit hit;
      cast(a_, ray, hit);
      found("cast", static_cast<bool>(hit));
      add("cast", hit.triangle, hit.t);
      std::vector<RayHit> hits;
      cast_all(a_, ray, scratch_, hits);
      for (const RayHit& one : hits) add("cast_all", one.triangle, one.t, one.barycentrics[0]);
      std::array<bool, 1> any = {};
      cast_any(a_, std::array{ray}, any);
      add("cast_any", any[0]);
    }
  }

  void ask_points() {
    for (int i = 0; i < 20; ++i) {
      ClosestPoint closest;
      closest_point(a_, random_.point(2), scratch_, closest);
      add("closest", closest.distance);
      add("closest", closest.point);
    }
  }

  void ask_regions() {
    for (int i = 0; i < 8; ++i) {
      const Vec3 p = random_.point(0.5), q = random_.point(0.5);
      const Solid solids[] = {Sphere{p, 0.3f}, Capsule{p, q, 0.2f}, HalfSpace{p, 0.1f},
                              OrientedBox{p, {}, {0.2f, 0.3f, 0.1f}}};
      for (const Solid& solid : solids) {
        SolidDistance near;
        distance(a_, solid, scratch_, near);
        add("solid distance", near.distance);
        std::visit([&](const auto& shape) { ask_region(shape); }, solid);
      }
    }
  }

  void ask_region(const Region& region) {
    Placement placement = {};
    classify(a_, region, scratch_, placement);
    add("classify", static_cast<int>(placement));
    std::vector<std::uint32_t> triangles;
    collide(a_, region, scratch_, triangles);
    found("region", triangles.size());
    for (const std::uint32_t t : triangles) add("region", t);
    std::vector<RegionEntry> entries;
    collide(move_a_, region, scratch_, entries);
    found("moving region", entries.size());
    for (const RegionEntry& entry : entries) add("moving region", entry.triangle, entry.time);
  }

  void ask_field() {
    std::vector<float> heights(20 * 20);
    for (float& height : heights) height = random_.uniformf(-0.2, 0.2);
    const HeightField field = *build_height_field({heights, 20, 20, {-1, 0, -1}, 0.1f, 0.1f});
    std::vector<Contact> contacts;
    collide(a_, field, scratch_, contacts);
    add("field", contacts);
    Distance nearest;
    distance(a_, field, scratch_, nearest);
    add("field distance", nearest.distance);
    std::vector<MovingContact> moving;
    collide(move_a_, field, scratch_, moving);
    add("moving field", moving);
  }

  void ask_motion() {
    std::vector<MovingContact> contacts;
    collide(move_a_, move_b_, scratch_, contacts);
    add("motion", contacts);
    std::optional<MovingContact> first;
    first_contact(move_a_, move_b_, scratch_, first);
    found("first contact", first.has_value());
    if (first) add("first contact", *first);
    const Motion resting = {a_, a_};
    contacts.clear();
    collide(resting, move_b_, scratch_, contacts);
    add("resting", contacts);
  }

  void ask_searches() {
    CollisionSearch search(a_, b_, SearchOrder::contacts);
    while (!search.is_complete()) search.advance(1000, scratch_);
    found("search", search.contacts().size());
    for (const Contact& c : search.contacts()) add("search", c.triangle_a, c.triangle_b);
    FirstContactSearch first(move_a_, move_b_);
    while (!first.is_complete()) first.advance(1000);
    if (first.earliest()) add("first contact search", *first.earliest());
  }

  Pose &a_, &b_;
  Motion move_a_, move_b_;
  Scratch& scratch_;
  Random random_{7};
  std::map<std::string, detail::Fnv1a64> hashes_;
  Answers answers_;
};

}  // namespace

Answers ask_every_query(Stage& stage, Scratch& scratch) { return Asker(stage, scratch).run(); }

}  // namespace pelt::test
