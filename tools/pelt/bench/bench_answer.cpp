#include "tools/pelt/bench/bench_answer.hpp"

#include "tools/pelt/scene/contact_hash.hpp"

namespace pelt::tools::bench {
namespace {

/// Hashes which pairs touch, because the first contact of a pair is unspecified.
class TouchHash {
 public:
  explicit TouchHash(Asked asked) : of_each_(asked == Asked::self) {}

  void add(std::uint32_t frame, std::size_t collider_count, const scene::FrameContacts& found) {
    auto pair = found.pairs.begin();
    for (std::uint32_t a = 0; a < collider_count; ++a) {
      const auto end = of_each_ ? a + 1 : static_cast<std::uint32_t>(collider_count);
      for (std::uint32_t b = of_each_ ? a : a + 1; b < end; ++b) {
        const bool touch = pair != found.pairs.end() && pair->a == a && pair->b == b;
        if (touch) ++pair;
        for (const std::uint32_t value : {frame, a, b, std::uint32_t{touch}}) hash_.add_u32(value);
      }
    }
  }

  std::uint64_t value() const { return hash_.value(); }

 private:
  bool of_each_;
  detail::Fnv1a64 hash_;
};

QueryStats difference(QueryStats after, const QueryStats& before) {
  after.node_pairs -= before.node_pairs;
  after.refits -= before.refits;
  after.posed_vertices -= before.posed_vertices;
  after.triangle_pairs -= before.triangle_pairs;
  return after;
}

/// The answer of the frames added so far.
struct AnswerSoFar {
  explicit AnswerSoFar(Asked asked) : touches(asked) {}

  void add(std::uint32_t frame, std::size_t collider_count, const scene::FrameContacts& found) {
    contacts.add(frame, found);
    touches.add(frame, collider_count, found);
    frames_in_contact += !found.contacts.empty();
    contact_count += found.contacts.size();
  }

  Answer to(Question question) const {
    const bool all = question == Question::all;
    return {all ? contacts.value() : touches.value(), work, frames_in_contact, contact_count};
  }

  scene::ContactHash contacts;
  TouchHash touches;
  QueryStats work;
  std::uint64_t frames_in_contact = 0, contact_count = 0;
};

}  // namespace

Result<std::vector<Answer>> answer(const Subject& subject, const BenchMethod& method,
                                   std::span<const Question> questions) {
  Runner runner(subject.colliders, method);
  asset::SampleScratch scratch;
  scene::Palettes palettes;
  std::vector<AnswerSoFar> answers(questions.size(), AnswerSoFar(method.asked));
  for (const std::uint32_t frame : subject.frames) {
    scene::sample_palettes(subject.scene, frame, scratch, palettes);
    for (std::size_t q = 0; q < questions.size(); ++q) {
      const QueryStats before = runner.work();
      if (const auto posed = runner.pose(palettes); !posed) return in_frame(frame, posed.error());
      runner.ask(questions[q]);
      answers[q].work += difference(runner.work(), before);
      answers[q].add(frame, subject.colliders.size(), runner.found());
    }
  }
  std::vector<Answer> result;
  for (std::size_t q = 0; q < questions.size(); ++q) result.push_back(answers[q].to(questions[q]));
  return result;
}

}  // namespace pelt::tools::bench
