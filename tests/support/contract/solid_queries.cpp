/// A body and regions or fields that do not move.

#include "field/fields.hpp"
#include "solid/region_oracle.hpp"
#include "support/contract/query.hpp"

namespace pelt::contract {
namespace {

TrianglesInRegion triangles_in_region(const Stage& stage) {
  return test::brute_force(stage.region, stage.a.shape.triangles, positions_of(stage.a.to));
}

QueryStats find_in_region(Stage& stage, TrianglesInRegion& found) {
  found.intersecting.clear(), found.inside.clear();
  return find_triangles(stage.a.to, stage.region, stage.scratch, found);
}

Placement placement_of(const Stage& stage) {
  return test::placement_of(triangles_in_region(stage), stage.a.shape.triangles.size());
}

/// Both bodies at once.
QueryStats classify_both(Stage& stage, std::vector<Placement>& found) {
  Pose* const poses[] = {&stage.a.to, &stage.b.to};
  found.resize(2);
  return classify(poses, stage.region, stage.scratch, found);
}

std::vector<Contact> contacts_with_field(const Stage& stage) {
  return test::brute_force(stage.field, stage.a.shape.triangles, positions_of(stage.a.to));
}

}  // namespace

void add_solid_queries(Queries& queries) {
  add(queries,
      ListRow<std::uint32_t>{
          .name = "CollideWithRegion",
          .ask = [](Stage& s, std::vector<std::uint32_t>& found,
                    std::uint32_t) { return collide(s.a.to, s.region, s.scratch, found); },
          .brute_force = [](const Stage& s) { return triangles_in_region(s).intersecting; }});
  add(queries, ValueRow<TrianglesInRegion>{
                   .name = "FindTriangles",
                   .ask = find_in_region,
                   .expect_right =
                       [](const Stage& s, const TrianglesInRegion& found) {
                         const TrianglesInRegion expected = triangles_in_region(s);
                         EXPECT_EQ(found.intersecting, expected.intersecting);
                         EXPECT_EQ(found.inside, expected.inside);
                       },
                   .is_hit = [](const TrianglesInRegion& found) { return !found.inside.empty(); },
                   .traits = {.reserves_when_asked = true}});
  add(queries,
      YesNoRow{.name = "IntersectsRegion",
               .ask = [](Stage& s) { return intersects(s.a.to, s.region, s.scratch); },
               .brute_force =
                   [](const Stage& s) { return !triangles_in_region(s).intersecting.empty(); }});
  add(queries,
      ValueRow<Placement>{
          .name = "Classify",
          .ask = [](Stage& s,
                    Placement& found) { return classify(s.a.to, s.region, s.scratch, found); },
          .expect_right = [](const Stage& s,
                             Placement found) { EXPECT_EQ(found, placement_of(s)); },
          .is_hit = [](Placement found) { return found == Placement::partly; }});
  add(queries, ValueRow<std::vector<Placement>>{
                   .name = "ClassifyPoses",
                   .ask = classify_both,
                   .expect_right =
                       [](const Stage& s, const std::vector<Placement>& found) {
                         EXPECT_EQ(found[0], placement_of(s));
                         const auto of_b =
                             test::brute_force(s.region, s.b.shape.triangles, positions_of(s.b.to));
                         EXPECT_EQ(found[1], test::placement_of(of_b, s.b.shape.triangles.size()));
                       },
                   .is_hit =
                       [](const std::vector<Placement>& found) {
                         return found[0] == Placement::partly || found[1] == Placement::partly;
                       }});
  add(queries, ListRow<Contact>{.name = "CollideWithField",
                                .ask =
                                    [](Stage& s, std::vector<Contact>& found, std::uint32_t limit) {
                                      return collide(s.a.to, s.field, s.scratch, found, {limit});
                                    },
                                .brute_force = contacts_with_field,
                                .traits = {.is_limited = true}});
  add(queries,
      YesNoRow{.name = "IntersectsField",
               .ask = [](Stage& s) { return intersects(s.a.to, s.field, s.scratch); },
               .brute_force = [](const Stage& s) { return !contacts_with_field(s).empty(); }});
}

}  // namespace pelt::contract
