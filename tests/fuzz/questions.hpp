#pragma once

/// Questions of the fuzz target of the queries. Each function reads its arguments from the bytes,
/// asks one or more queries, and ends the program if an answer differs from that of all posed
/// triangles one by one.

#include "fuzz/fuzzed_bodies.hpp"

#include <pelt/query.hpp>

namespace pelt::test {

struct Question {
  FuzzBytes& bytes;
  FuzzedBody &a, &b;
  Scratch& scratch;
};

void ask_contacts(Question& question);
void ask_contact_geometry(Question& question);
void ask_distance(Question& question);
void ask_clearance(Question& question);
void ask_triangle_distance(Question& question);
void ask_closest_point(Question& question);
void ask_ray(Question& question);
void ask_region(Question& question);
void ask_solid_distance(Question& question);
void ask_solid_cast(Question& question);
void ask_side(Question& question);
void ask_deepest_vertex(Question& question);
void ask_containment(Question& question);
void ask_bounds(Question& question);
void ask_groups(Question& question);
void ask_farthest(Question& question);
void ask_field_contacts(Question& question);
void ask_field_distance(Question& question);
void ask_field_cast(Question& question);
void ask_crowd(Question& question);
void ask_self_contacts(Question& question);

}  // namespace pelt::test
