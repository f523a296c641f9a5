#include "field/fields.hpp"
#include "fuzz/fuzzed_operands.hpp"
#include "fuzz/goal.hpp"
#include "fuzz/pair_oracle.hpp"
#include "fuzz/questions.hpp"
#include "geometry/ray_triangle.hpp"
#include "ray/ray_oracle.hpp"
#include "support/require.hpp"

#include <pelt/height_field.hpp>

#include <algorithm>

namespace pelt::test {
namespace {

Goal field_touched("collide with a height field: contacts"),
    field_missed("collide with a height field: no contact"),
    field_apart("distance from a height field"), field_hit("cast against a height field: a hit"),
    field_ray_missed("cast against a height field: a miss"), holes("a height field with holes"),
    blocks("a height field of several blocks");

/// The triangles of a field that exist, and their numbers.
struct Ground {
  explicit Ground(const HeightField& field) {
    for (std::uint32_t t = 0; t < field.triangle_count(); ++t) {
      if (is_hole(field.triangle(t))) continue;
      triangles.push_back(field.triangle(t));
      numbers.push_back(t);
    }
    holes.reach(numbers.size() < field.triangle_count());
    blocks.reach(std::max(field.columns(), field.rows()) > 5);
  }

  std::vector<detail::TriangleCorners> triangles;
  std::vector<std::uint32_t> numbers;
};

std::vector<Contact> expected_contacts(const FuzzedBody& body, const Ground& ground) {
  std::vector<Contact> expected = intersecting_pairs(body.all_corners(), ground.triangles);
  for (Contact& contact : expected) contact.triangle_b = ground.numbers[contact.triangle_b];
  return expected;
}

RayHit expected_hit(const Ground& ground, const Ray& ray, Facing facing) {
  RayHit first;
  const detail::RayLine line = {ray.origin, ray.direction};
  for (std::size_t i = 0; i < ground.triangles.size(); ++i) {
    detail::RayCrossing crossing;
    if (!detail::line_meets_triangle(line, ground.triangles[i], crossing)) continue;
    if (crossing.t < ray.t_min || crossing.t > ray.t_max) continue;
    if (facing != Facing::both && crossing.from_front != (facing == Facing::front)) continue;
    if (first && crossing.t >= first.t) continue;
    first = {ground.numbers[i],
             {},
             crossing.t,
             detail::crossing_weights(line, ground.triangles[i], crossing),
             detail::unit_normal(ground.triangles[i])};
  }
  return first;
}

}  // namespace

void ask_field_contacts(Question& q) {
  const std::optional<HeightField> field = make_field(q.bytes);
  if (!field) return;
  const std::vector<Contact> expected = expected_contacts(q.a, Ground(*field));
  std::vector<Contact> found;
  collide(q.a.pose, *field, q.scratch, found);
  require(found == expected, "collide with a height field");
  require(static_cast<bool>(intersects(q.a.pose, *field, q.scratch)) == !expected.empty(),
          "intersects of a height field");
  (found.empty() ? field_missed : field_touched).reach();
}

void ask_field_distance(Question& q) {
  const std::optional<HeightField> field = make_field(q.bytes);
  if (!field) return;
  const Ground ground(*field);
  const LeastDistance expected = least_distance(q.a.all_corners(), ground.triangles);
  Distance found;
  distance(q.a.pose, *field, q.scratch, found);
  require(found.distance == expected.distance, "distance from a height field");
  if (!found) return;
  require(found.a.triangle == expected.triangle_a &&
              found.b.triangle == ground.numbers[expected.triangle_b],
          "the triangles of a distance from a height field");
  Distance again;
  distance(q.a.pose, *field, q.scratch, again, {.max_distance = expected.distance, .hint = &found});
  require(again.distance == expected.distance, "a hint for a height field");
  field_apart.reach(found.distance > 0);
}

void ask_field_cast(Question& q) {
  const std::optional<HeightField> field = make_field(q.bytes);
  if (!field) return;
  const Ray ray = make_ray(q.bytes, q.a);
  const Facing facing = static_cast<Facing>(q.bytes.index(3));
  RayHit found;
  cast(*field, ray, found, facing);
  require(without_location(found) == expected_hit(Ground(*field), ray, facing),
          "cast against a height field");
  (found ? field_hit : field_ray_missed).reach();
}

}  // namespace pelt::test
