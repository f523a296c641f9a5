/// The fuzz target of the queries: bytes -> an instruction set, two bodies, and questions about
/// them, in each way of posing the bodies. Every answer is compared with all posed triangles, one
/// by one. Whether two triangles intersect, which triangles a region contains, and which side a
/// point is on is decided here by exact numbers. Distances and rays are compared with the library's
/// definition for one triangle; that of the distance is compared with rational numbers.

#include "fuzz/questions.hpp"

#include <pelt/config.hpp>

namespace pelt::test {
namespace {

void move_either(Question& question) {
  move_body(question.bytes, question.bytes.index(2) == 0 ? question.a : question.b);
}

void swap_bodies(Question& question) { std::swap(question.a, question.b); }

constexpr void (*kQuestions[])(Question&) = {
    move_either,    swap_bodies,        ask_contacts,          ask_contact_geometry,
    ask_distance,   ask_clearance,      ask_triangle_distance, ask_closest_point,
    ask_ray,        ask_region,         ask_solid_distance,    ask_solid_cast,
    ask_side,       ask_deepest_vertex, ask_containment,       ask_bounds,
    ask_groups,     ask_farthest,       ask_field_contacts,    ask_field_distance,
    ask_field_cast, ask_crowd,          ask_self_contacts};

void ask_all(FuzzBytes bytes, Posing posing) {
  const auto sets = available_instruction_sets();
  set_active_instruction_set(sets[bytes.index(static_cast<std::uint32_t>(sets.size()))]);
  std::optional<FuzzedBody> a = make_body(bytes, posing), b = make_body(bytes, posing);
  if (!a || !b) return;
  Scratch scratch;
  Question question = {bytes, *a, *b, scratch};
  constexpr int kMostQuestions = 12;
  for (int i = 0; i < kMostQuestions && !bytes.is_empty(); ++i)
    kQuestions[bytes.index(std::size(kQuestions))](question);
}

}  // namespace
}  // namespace pelt::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using pelt::test::Posing;
  const pelt::test::FuzzBytes bytes(std::span(data, size));
  for (const Posing posing : {Posing::joints, Posing::offsets, Posing::given})
    pelt::test::ask_all(bytes, posing);
  return 0;
}
