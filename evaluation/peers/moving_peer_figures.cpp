#include "evaluation/peers/moving_peer_figures.hpp"

#include "evaluation/methods/moving_methods.hpp"
#include "model/model.hpp"
#include "model/unpack.hpp"
#include "text/format.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace pelt::tools {

namespace {

using lab::MovingBenchMethod;
using lab::MovingQuestion;
using lab::MovingRunner;
using lab::MovingSubject;
using lab::Step;
using lab::StepAnswer;

class MovingAdapter final : public lab::MovingMethod {
 public:
  explicit MovingAdapter(std::unique_ptr<peers::MovingMeshMethod> method)
      : method_(std::move(method)) {}

  void add(const SkinnedModel& model) override {
    const auto mesh =
        meshes_.try_emplace(&model.detail(), detail::unpack_mesh(model.detail().tree)).first;
    bodies_.push_back({Pose(model), std::vector<Vec3>(model.vertex_count())});
    method_->add(mesh->second.triangles, mesh->second.rest_positions);
  }

  void begin_step() override {}

  Result<void> set_morph_weights(std::uint32_t body, std::span<const float> weights) override {
    return bodies_[body].pose.set_morph_weights(weights);
  }

  Result<void> set_palette(std::uint32_t body, std::span<const Matrix4> palette) override {
    auto& [pose, positions] = bodies_[body];
    Result<void> taken = pose.set_palette(palette);
    if (!taken) return taken;
    posed_vertices(pose, positions);
    update_work_.posed_vertices += positions.size();
    method_->update(body, positions);
    return taken;
  }

  QueryStats collide_at_end(std::uint32_t, std::uint32_t, std::vector<Contact>&) override {
    return {};
  }

  MovingStats collide_moving(std::uint32_t a, std::uint32_t b, std::vector<MovingContact>& contacts,
                             const MovingOptions& options) override {
    pairs_.clear();
    method_->collide_moving(a, b, options.max_contacts, pairs_);
    std::sort(pairs_.begin(), pairs_.end(),
              [](const auto& p, const auto& q) { return p.contact < q.contact; });
    for (const peers::TimedPair& pair : pairs_)
      contacts.push_back({pair.contact, static_cast<float>(pair.time), false, {}, {}});
    return {};
  }

  bool finds_first_contact() const override { return false; }

  MovingStats first_contact(std::uint32_t, std::uint32_t, std::optional<MovingContact>&) override {
    return {};
  }

  QueryStats update_work() const override { return update_work_; }

 private:
  struct Body {
    Pose pose;
    std::vector<Vec3> positions;
  };

  std::unique_ptr<peers::MovingMeshMethod> method_;
  std::map<const detail::Model*, detail::SkinnedMesh> meshes_;
  std::vector<Body> bodies_;
  std::vector<peers::TimedPair> pairs_;
  QueryStats update_work_;
};

/// Finds nothing.
class MovingSkinningOnly final : public peers::MovingMeshMethod {
 public:
  void add(std::span<const Triangle>, std::span<const Vec3>) override {}
  void update(std::uint32_t, std::span<const Vec3>) override {}
  void collide_moving(std::uint32_t, std::uint32_t, std::uint32_t,
                      std::vector<peers::TimedPair>&) override {}
};

constexpr std::size_t kOurs = 2;  // methods that skin during their update or query

/// Pelt's methods, the peers, then skinning alone.
std::vector<MovingBenchMethod> moving_contestants() {
  return {{"pelt on_demand", lab::kMovingOnDemand.make},
          {"pelt eager", lab::kMovingEager.make},
          {"fcl", [] { return adapt_moving(peers::make_fcl_moving(1)); }},
          {"fcl in 1/1000", [] { return adapt_moving(peers::make_fcl_moving(1000)); }},
          {"skinning", [] { return adapt_moving(std::make_unique<MovingSkinningOnly>()); }}};
}

std::span<const MovingContact> contacts_of(const StepAnswer& found, const StepAnswer::Pair& pair) {
  const auto place = std::find_if(found.pairs.begin(), found.pairs.end(), [&](const auto& other) {
    return other.a == pair.a && other.b == pair.b;
  });
  if (place == found.pairs.end()) return {};
  return std::span(found.contacts).subspan(place->begin, place->end - place->begin);
}

peers::MovingDifference compare_steps(const StepAnswer& answer, const StepAnswer& exact) {
  peers::MovingDifference sum;
  for (const StepAnswer::Pair& pair : exact.pairs)
    sum += peers::compare_moving(contacts_of(answer, pair), contacts_of(exact, pair));
  for (const StepAnswer::Pair& pair : answer.pairs)
    if (contacts_of(exact, pair).empty())
      sum += peers::compare_moving(contacts_of(answer, pair), {});
  return sum;
}

/// Finds all contacts of a step with times.
Result<void> ask_step(MovingRunner& runner, const scene::Palettes& from,
                      const scene::Palettes& to) {
  for (const scene::Palettes* end : {&from, &to})
    if (Result<void> posed = runner.advance(*end); !posed) return posed;
  runner.ask(MovingQuestion::times);
  return {};
}

/// Counts the contacts of brute force, and how the others differ from them.
Result<void> compare_all_steps(const MovingSubject& subject, MovingScenePeers& scene) {
  std::vector<MovingRunner> runners;
  for (const MovingBenchMethod& method : moving_contestants())
    runners.emplace_back(subject.colliders, method);
  MovingRunner exact(subject.colliders, lab::method_of(lab::kMovingBrute));
  asset::SampleScratch scratch;
  scene::Palettes from, to;
  for (const Step& step : subject.steps) {
    scene::sample_palettes(subject.scene, step.from, scratch, from);
    scene::sample_palettes(subject.scene, step.to, scratch, to);
    if (const auto asked = ask_step(exact, from, to); !asked)
      return lab::in_step(step, asked.error());
    const auto& contacts = exact.found().contacts;
    scene.contacts += contacts.size();
    scene.contacts_at_start += static_cast<std::size_t>(std::count_if(
        contacts.begin(), contacts.end(), [](const MovingContact& c) { return c.at_start; }));
    scene.steps_in_contact += !contacts.empty();
    for (std::size_t m = 0; m < scene.methods.size(); ++m) {
      if (const auto asked = ask_step(runners[m], from, to); !asked)
        return lab::in_step(step, asked.error());
      scene.methods[m].difference += compare_steps(runners[m].found(), exact.found());
    }
  }
  return {};
}

}  // namespace

std::unique_ptr<lab::MovingMethod> adapt_moving(std::unique_ptr<peers::MovingMeshMethod> method) {
  return std::make_unique<MovingAdapter>(std::move(method));
}

Result<MovingScenePeers> measure_moving_peers(const MovingSubject& subject,
                                              std::uint32_t repetitions) {
  const std::vector<MovingBenchMethod> all = moving_contestants();
  MovingScenePeers scene;
  scene.scene = subject.scene.name;
  scene.steps = subject.steps.size();
  scene.repetitions = repetitions;
  for (const scene::Collider& collider : subject.colliders)
    scene.triangles += collider.model.triangle_count();
  for (std::size_t m = 0; m + 1 < all.size(); ++m) scene.methods.push_back({all[m].name});
  if (const auto compared = compare_all_steps(subject, scene); !compared) return compared.error();
  constexpr std::array kQuestions = {MovingQuestion::times};
  const auto times = lab::measure_moving(subject, all, kQuestions, repetitions, [] {});
  if (!times) return times.error();
  const double skinning_us = times->back()[0].mean_update_us;
  for (std::size_t m = 0; m < scene.methods.size(); ++m) {
    const bench::Times& of = (*times)[m][0];
    MovingPeerFigures& figures = scene.methods[m];
    figures.skinning_us = m < kOurs ? 0 : skinning_us;
    figures.update_us = std::max(0.0, of.mean_update_us - figures.skinning_us);
    figures.query_us = of.mean_query_us();
    figures.step_us = of.mean_us;
  }
  return scene;
}

void print_moving_peers(const MovingScenePeers& scene, std::ostream& out) {
  out << scene.scene << ": " << text::with_commas(scene.triangles) << " triangles, "
      << text::counted(scene.steps, "step") << " of which " << scene.steps_in_contact
      << " in contact, " << text::with_commas(scene.contacts) << " contacts in all, "
      << text::with_commas(scene.contacts_at_start) << " of them from the start of the step\n"
      << "microseconds a step on one thread, medians of " << scene.repetitions
      << ", means over the steps; less is better\n";
  constexpr bench::Column kColumns[] = {{"method", "method"},    {"skinning_us", "skinning"},
                                        {"update_us", "update"}, {"query_us", "query"},
                                        {"step_us", "step"},     {"of_pelt", "of pelt's"},
                                        {"missing", "missing"},  {"at_start", "at start"},
                                        {"extra", "extra"},      {"early", "early"},
                                        {"late", "late"}};
  std::vector<bench::Row> rows;
  for (const MovingPeerFigures& of : scene.methods)
    rows.push_back({{"method", of.method},
                    {"skinning_us", of.skinning_us},
                    {"update_us", of.update_us},
                    {"query_us", of.query_us},
                    {"step_us", of.step_us},
                    {"of_pelt", of.step_us / scene.methods[0].step_us},
                    {"missing", of.difference.missing_later},
                    {"at_start", of.difference.missing_at_start},
                    {"extra", of.difference.extra},
                    {"early", of.difference.early},
                    {"late", of.difference.late}});
  bench::print_table(kColumns, rows, out, {18, 12});
  out << '\n';
}

}  // namespace pelt::tools
