#include "evaluation/bench/moving_runner.hpp"

#include "scenes/takes.hpp"
#include "text/format.hpp"
#include "text/message.hpp"
#include "tools/pelt/bench/runner.hpp"

namespace pelt::lab {
namespace {

bool is_step(const scenes::Scene& scene, std::uint32_t from) {
  return from + 1 < scene.frame_count &&
         scenes::take_index(scene, from) == scenes::take_index(scene, from + 1);
}

}  // namespace

const char* name_of(MovingQuestion question) {
  constexpr std::array kNames = {"collide", "pairs", "times", "first", "touch"};
  return kNames[static_cast<std::size_t>(question)];
}

Result<std::vector<Step>> choose_steps(const scenes::Scene& scene,
                                       const std::optional<tools::arguments::FrameRange>& chosen) {
  const auto frames = tools::bench::choose_frames(scene, chosen);
  if (!frames) return frames.error();
  std::vector<Step> steps;
  for (const std::uint32_t from : *frames)
    if (is_step(scene, from))
      steps.push_back({from > 0 && is_step(scene, from - 1) ? from - 1 : from, from, from + 1});
  if (steps.empty())
    return text::bad_argument("--frames", "no step begins with these frames",
                              "choose a frame that has a next one");
  return steps;
}

Error in_step(const Step& step, const Error& error) {
  return text::prefixed(
      "step from frame " + std::to_string(step.from) + " to " + std::to_string(step.to), error);
}

MovingBenchMethod method_of(const MovingMethodKind& kind) {
  return {std::string(kind.name), kind.make};
}

MovingRunner::MovingRunner(std::span<const scene::Collider> colliders,
                           const MovingBenchMethod& method)
    : colliders_(colliders), parted_(colliders), method_(method.make()) {
  for (const scene::Collider& collider : colliders_) method_->add(collider.model);
}

Result<void> MovingRunner::advance(const scene::Palettes& palettes) {
  if (Result<void> checked = parted_.check(palettes); !checked) return checked;
  method_->begin_step();
  for (std::uint32_t c = 0; c < colliders_.size(); ++c) {
    const auto posed = scene::set_pose(selection_.select(palettes, colliders_[c]), *method_, c);
    if (!posed) return scene::in_instance(colliders_[c].instance, posed.error());
  }
  return {};
}

void MovingRunner::ask(MovingQuestion question) {
  found_.pairs.clear();
  found_.contacts.clear();
  const auto count = static_cast<std::uint32_t>(colliders_.size());
  for (std::uint32_t a = 0; a < count; ++a)
    for (std::uint32_t b = a + 1; b < count; ++b) {
      const std::size_t begin = found_.contacts.size();
      ask_pair(question, a, b);
      if (const std::size_t end = found_.contacts.size(); end > begin)
        found_.pairs.push_back({a, b, begin, end});
    }
}

void MovingRunner::ask_pair(MovingQuestion question, std::uint32_t a, std::uint32_t b) {
  MovingOptions options;
  options.times = question == MovingQuestion::times;
  if (question == MovingQuestion::touch) options.max_contacts = 1;
  if (question == MovingQuestion::collide) {
    discrete_.clear();
    query_work_.QueryStats::operator+=(method_->collide_at_end(a, b, discrete_));
    for (const Contact& contact : discrete_) found_.contacts.push_back({contact, 0, false, {}, {}});
  } else if (question == MovingQuestion::first) {
    std::optional<MovingContact> first;
    query_work_ += method_->first_contact(a, b, first);
    if (first) found_.contacts.push_back(*first);
  } else {
    query_work_ += method_->collide_moving(a, b, found_.contacts, options);
  }
}

MovingStats MovingRunner::work() const {
  MovingStats work = query_work_;
  work.QueryStats::operator+=(method_->update_work());
  return work;
}

}  // namespace pelt::lab
