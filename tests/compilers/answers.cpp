/// Prints what queries answer on random bodies, as hashes: one line for each instruction set and
/// query. Two builds of Pelt that promise the same bits print the same lines for the instruction
/// sets that both have. Both must be built by one compiler, because the random bodies depend on the
/// order in which a compiler evaluates arguments. The bodies need no sines, which are not the same
/// in all standard libraries.

#include <pelt/config.hpp>
#include <pelt/pelt.hpp>

#include "base/hash.hpp"
#include "support/pinned_shapes.hpp"
#include "support/prepared_file.hpp"
#include "support/skinned_shapes.hpp"
#include "support/use_model.hpp"

#include <cstdio>
#include <cstring>
#include <map>
#include <string>
#include <type_traits>
#include <vector>

namespace {

using namespace pelt;
using test::Random;
using test::Shape;

/// Hashes of the answers, by the name of the query.
class Answers {
 public:
  template <typename T>
  void add_bits(const char* query, const T& value) {
    std::byte bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    hashes_[query].add_bytes(bytes);
  }

  template <typename... Values>
  requires(std::is_arithmetic_v<Values>&&...) void add(const char* query, const Values&... values) {
    (add_bits(query, values), ...);
  }

  void add(const char* query, const Vec3& v) { add(query, v.x, v.y, v.z); }

  void add(const char* query, const QueryStats& work) {
    add(query, work.node_pairs, work.refits, work.posed_vertices, work.triangle_pairs);
  }

  void found(bool anything) { found_ += anything; }

  void print(const char* set) const {
    for (const auto& [query, hash] : hashes_)
      std::printf("%s %s %016llx\n", set, query.c_str(),
                  static_cast<unsigned long long>(hash.value()));
    std::printf("%s found %u\n", set, found_);
  }

 private:
  std::map<std::string, detail::Fnv1a64> hashes_;
  unsigned found_ = 0;
};

/// Scale, shear and reflection, and a translation up to 0.5.
std::vector<Matrix4> random_palette(Random& random, std::uint32_t joint_count) {
  std::vector<Matrix4> palette(joint_count);
  for (Matrix4& joint : palette)
    for (std::size_t column = 0; column < 4; ++column)
      for (std::size_t row = 0; row < 3; ++row) {
        const double identity = column == row ? 1 : 0;
        joint.m[4 * column + row] = random.uniformf(identity - 0.5, identity + 0.5);
      }
  return palette;
}

struct Body {
  Shape shape;
  std::vector<Matrix4> palette;
  std::vector<float> morph_weights;
};

Body random_soup(Random& random) {
  Body body{test::make_soup(random, 400, 6, 4, test::Weights::adversarial),
            random_palette(random, 6),
            {}};
  test::add_morph_targets(random, body.shape, 3, 0.3, 0.1);
  body.morph_weights = test::make_morph_weights(random, 3, test::Morphing::all);
  return body;
}

/// A closed surface with any vertices.
Body random_torus(Random& random) {
  std::vector<Vec3> positions(36);
  for (Vec3& position : positions) position = random.point(1);
  return {test::make_pinned(36, test::torus(6, 6)), test::pin(positions), {}};
}

Pose pose_of(const Body& body, const SkinnedModel& model) {
  Pose pose(model);
  const bool is_set = pose.set_morph_weights(body.morph_weights) && pose.set_palette(body.palette);
  if (!is_set) std::puts("a palette was refused");
  return pose;
}

void add_model(const SkinnedModel& model, const Pose& pose, Answers& answers) {
  for (const std::byte byte : save_model(model))
    answers.add("prepared", static_cast<std::uint8_t>(byte));
  std::vector<Vec3> positions(model.vertex_count());
  posed_vertices(pose, positions);
  for (const Vec3& position : positions) answers.add("posed", position);
}

/// Loads files with one damaged number, in the header every other time.
void add_damaged(Random& random, const SkinnedModel& model, Answers& answers) {
  const test::Bytes saved = save_model(model);
  const std::size_t numbers[] = {sizeof(detail::PreparedHeader) / 4, saved.size() / 4};
  for (std::size_t i = 0; i < 100; ++i) {
    test::Bytes file = saved;
    const std::uint32_t values[] = {0, 0x7FFFFFFF, 0xFFFFFFFF, 1u << random.index(32)};
    const std::uint32_t value = values[random.index(4)];
    const auto place = 4 * random.index(static_cast<std::uint32_t>(numbers[i % 2]));
    std::memcpy(&file[place], &value, sizeof value);
    test::mend(file);
    const Result<SkinnedModel> loaded = load_model(file);
    answers.found(!loaded);
    answers.add("damaged", loaded && test::use_model(*loaded));
    if (loaded) continue;
    for (const char letter : loaded.error().message) answers.add("damaged", letter);
  }
}

void add_bounds(Pose& pose, Answers& answers) {
  for (const std::uint32_t levels : {0u, 2u}) {
    Bounds box;
    answers.add("bounds", bounds(pose, box, levels));
    answers.add("bounds", box.box.low);
    answers.add("bounds", box.box.high);
    answers.add("bounds", box.sphere.radius);
  }
}

void add_contacts(Pose& a, Pose& b, Scratch& scratch, Answers& answers) {
  std::vector<Contact> contacts;
  answers.add("collide", collide(a, b, scratch, contacts));
  for (const Contact& contact : contacts)
    answers.add("collide", contact.triangle_a, contact.triangle_b);
  answers.found(!contacts.empty());

  ContactGeometry geometry;
  describe_contacts(a, b, contacts, scratch, geometry);
  for (const ContactTrace& trace : geometry.traces) {
    answers.add("describe", trace.from);
    answers.add("describe", trace.to);
    answers.add("describe", trace.normal);
    answers.add("describe", trace.depth);
  }
}

void add_distances(Pose& a, Pose& b, Scratch& scratch, Answers& answers) {
  std::vector<Contact> pairs;
  answers.add("clearance", clearance(a, b, 0.01, scratch, pairs));
  for (const Contact& pair : pairs) answers.add("clearance", pair.triangle_a, pair.triangle_b);
  Distance found;
  answers.add("distance", distance(a, b, scratch, found));
  answers.add("distance", found.distance);
  answers.add("distance", found.a.position);
}

void add_points(Random& random, Pose& pose, Scratch& scratch, Answers& answers) {
  for (int i = 0; i < 20; ++i) {
    const Vec3 point = random.point(2);
    ClosestPoint closest;
    answers.add("closest", closest_point(pose, point, scratch, closest));
    answers.add("closest", closest.distance);
    answers.add("closest", closest.point.position);
    RayHit hit;
    answers.add("cast", cast(pose, segment(point, random.point(2)), hit));
    answers.add("cast", hit.triangle, hit.t, hit.barycentrics[0]);
    answers.found(static_cast<bool>(hit));
    if (!pose.model().surface().is_closed()) continue;
    PointSide side = PointSide::outside;
    answers.add("side", side_of(pose, point, scratch, side));
    answers.add("side", static_cast<std::uint8_t>(side));
    answers.found(side == PointSide::inside);
  }
}

void add_crowd(const SkinnedModel& model, const Body& a, const Body& b, Answers& answers) {
  Crowd crowd;
  for (const Body* body : {&a, &b}) {
    const std::uint32_t instance = crowd.add(model);
    if (!crowd.set_palette(instance, body->palette)) std::puts("a palette was refused");
  }
  std::vector<CrowdContact> contacts;
  answers.add("crowd", crowd.collide(contacts, {.threads = 2}));
  for (const CrowdContact& contact : contacts)
    answers.add("crowd", contact.triangle_a, contact.triangle_b);
}

void add_round(std::uint64_t seed, Answers& answers) {
  Random random(seed);
  Scratch scratch;
  const auto add_pair = [&](const Body& first, const Body& second) {
    const auto model_a = build_model(first.shape.view()),
               model_b = build_model(second.shape.view());
    if (!model_a || !model_b) {
      std::puts("a model was refused");
      return;
    }
    Pose a = pose_of(first, *model_a), b = pose_of(second, *model_b);
    add_model(*model_a, a, answers);
    add_damaged(random, *model_a, answers);
    add_bounds(a, answers);
    add_contacts(a, b, scratch, answers);
    add_distances(a, b, scratch, answers);
    add_points(random, a, scratch, answers);
    add_crowd(*model_a, first, {first.shape, random_palette(random, first.shape.joint_count), {}},
              answers);
  };
  const Body soup_a = random_soup(random), soup_b = random_soup(random);
  const Body torus_a = random_torus(random), torus_b = random_torus(random);
  add_pair(soup_a, soup_b);
  add_pair(torus_a, torus_b);
}

}  // namespace

int main() {
  for (const InstructionSet set : available_instruction_sets()) {
    set_active_instruction_set(set);
    Answers answers;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) add_round(seed, answers);
    answers.print(name_of(set));
  }
}
