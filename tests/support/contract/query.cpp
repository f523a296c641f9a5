#include "support/contract/query.hpp"

namespace pelt::contract {

void add(Queries& queries, YesNoRow row) {
  const auto ask = row.ask;
  const auto brute_force = row.brute_force;
  add(queries,
      ValueRow<bool>{
          .name = row.name,
          .ask =
              [ask](Stage& stage, bool& found) {
                const YesNo answer = ask(stage);
                EXPECT_FALSE(answer.cut_short);
                found = answer.answer;
                return QueryStats(answer);
              },
          .expect_right = [brute_force](const Stage& stage,
                                        bool found) { EXPECT_EQ(found, brute_force(stage)); },
          .is_hit = [](bool found) { return found; },
          .traits = row.traits,
          .expect_swapped = [](bool found, bool swapped) { EXPECT_EQ(swapped, found); }});
}

const Queries& queries() {
  static const Queries all = [] {
    Queries rows;
    add_contact_queries(rows);
    add_self_queries(rows);
    add_moving_queries(rows);
    add_distance_queries(rows);
    add_solid_queries(rows);
    add_ray_and_bounds_queries(rows);
    add_inside_queries(rows);
    add_crowd_queries(rows);
    return rows;
  }();
  return all;
}

}  // namespace pelt::contract
