#include "evaluation/reproduce/comparison.hpp"

#include "evaluation/bench/bench.hpp"

#include "evaluation/reproduce/scene_figures.hpp"
#include "evaluation/rivals/layered_depth.hpp"
#include "tools/pelt/bench/measure.hpp"

#include <algorithm>
#include <numeric>

namespace pelt::reproduce {
namespace {

using methods::MethodKind;
using tools::bench::Question;

constexpr std::array kResolutions = {8u, 16u, 32u, 64u, 128u, 256u};
constexpr std::array kExact = {methods::kOnDemand, methods::kEager, methods::kPaper,  lab::kHybrid,
                               lab::kAabbRefit,    lab::kHash,      lab::kHashOverlap};

/// From hands that nearly touch to arms deep in the other body, because light contacts are the hard
/// ones.
constexpr double kFrom = 0.9, kTo = 0.3;

/// Images as a method: if two bodies seem to touch, an arbitrary pair of triangles represents the
/// answer.
class Images final : public rivals::PosedMeshMethod {
 public:
  explicit Images(std::uint32_t resolution) : images_(resolution) {}

  void add(std::span<const Triangle> triangles, std::span<const Vec3>) override {
    images_.add(triangles);
  }
  void update(std::uint32_t body, std::span<const Vec3> positions) override {
    images_.update(body, positions);
  }
  QueryStats collide(std::uint32_t a, std::uint32_t b, std::vector<Contact>& contacts,
                     std::uint32_t max_contacts) override {
    if (max_contacts > 0 && images_.touch(a, b)) contacts.push_back({0, 0});
    return {};
  }

 private:
  rivals::LayeredDepth images_;
};

/// The images by resolution, then the exact methods.
std::vector<tools::bench::BenchMethod> image_methods() {
  std::vector<tools::bench::BenchMethod> all;
  for (const std::uint32_t resolution : kResolutions)
    all.push_back(lab::rival_method("images " + std::to_string(resolution),
                                    [resolution] { return std::make_unique<Images>(resolution); }));
  for (const MethodKind method : kExact) all.push_back(tools::bench::method_of(method));
  return all;
}

/// Whether the two bodies touch, frame by frame.
Result<std::vector<bool>> ask(const tools::bench::Subject& subject,
                              const tools::bench::BenchMethod& method) {
  tools::bench::Runner runner(subject.colliders, method);
  asset::SampleScratch scratch;
  tools::scene::Palettes palettes;
  std::vector<bool> touching;
  for (const std::uint32_t frame : subject.frames) {
    tools::scene::sample_palettes(subject.scene, frame, scratch, palettes);
    if (const auto posed = runner.pose(palettes); !posed)
      return tools::bench::in_frame(frame, posed.error());
    runner.ask(Question::first);
    touching.push_back(!runner.found().contacts.empty());
  }
  return touching;
}

/// Number of frames in which the first says yes and the second says no.
double count_only(const std::vector<bool>& first, const std::vector<bool>& second) {
  return std::inner_product(first.begin(), first.end(), second.begin(), 0.0, std::plus<>(),
                            [](bool a, bool b) { return a && !b ? 1.0 : 0.0; });
}

/// Answer and time of every method in every frame.
struct Answers {
  std::vector<std::vector<bool>> touching;  // [methods][frames]
  std::vector<std::vector<tools::bench::Times>> times;

  const std::vector<bool>& exact() const { return touching[kResolutions.size()]; }
  double missed(std::size_t method) const { return count_only(exact(), touching[method]); }
  double invented(std::size_t method) const { return count_only(touching[method], exact()); }
};

Result<Answers> ask_all(const tools::bench::Subject& subject, const Conditions& conditions) {
  const std::vector<tools::bench::BenchMethod> all = image_methods();
  const std::array kFirst = {tools::bench::Variant{Question::first}};
  auto times = tools::bench::measure(subject, all, kFirst, conditions.is_quick ? 3 : 9, [] {});
  if (!times) return times.error();
  Answers answers = {{}, std::move(*times)};
  for (const tools::bench::BenchMethod& method : all) {
    auto touching = ask(subject, method);
    if (!touching) return touching.error();
    answers.touching.push_back(std::move(*touching));
  }
  return answers;
}

Table image_table(const Answers& answers, const std::string& note) {
  Table table = {"image_space",
                 "Layered depth images: do two creatures touch?",
                 {{"resolution", "pixels per side"},
                  {"images_us", "drawing and comparing [us], without skinning"},
                  {"all_us", "with skinning [us]"},
                  {"asked", "cases"},
                  {"touching", "cases that touch"},
                  {"missed", "contacts missed [cases]"},
                  {"missed_percent", "contacts missed [% of cases that touch]"},
                  {"invented", "contacts seen where there are none [cases]"}},
                 {},
                 note};
  const auto& exact = answers.exact();
  const auto touching = static_cast<double>(std::count(exact.begin(), exact.end(), true));
  for (std::size_t i = 0; i < kResolutions.size(); ++i) {
    const tools::bench::Times& times = answers.times[i][0];
    table.rows.push_back({static_cast<double>(kResolutions[i]),
                          times.mean_us - times.mean_update_us, times.mean_us,
                          static_cast<double>(exact.size()), touching, answers.missed(i),
                          100 * answers.missed(i) / std::max(touching, 1.0), answers.invented(i)});
  }
  return table;
}

Table rival_table(const Answers& answers, const std::string& note) {
  Table table = {"image_space_rivals",
                 "The same cases with exact methods: first contact only",
                 {{"method", "method"},
                  {"all_us", "with skinning [us]"},
                  {"missed", "contacts missed [cases]"},
                  {"invented", "contacts seen where there are none [cases]"}},
                 {},
                 note};
  for (std::size_t m = 0; m < kExact.size(); ++m) {
    const std::size_t method = kResolutions.size() + m;
    table.rows.push_back({title_of(kExact[m]), answers.times[method][0].mean_us,
                          answers.missed(method), answers.invented(method)});
  }
  return table;
}

void add_charts(Section& section) {
  Chart time = {"image_space",           "Layered depth images: time of an answer",
                "image_space",           "resolution",
                {"images_us", "all_us"}, "a case [us]"};
  Chart missed = {"image_space_missed", "Layered depth images: missed contacts",
                  "image_space",        "resolution",
                  {"missed_percent"},   "contacts missed [% of cases that touch]"};
  missed.axes = Axes::logarithmic_x;
  section.charts.push_back(std::move(time));
  section.charts.push_back(std::move(missed));
}

}  // namespace

Result<void> add_image_space(const scenes::Character& character, const Conditions& conditions,
                             Section& section) {
  const std::uint32_t count = conditions.is_quick ? 16 : 64;
  const scenes::Scene scene = closing_pair(character, kFrom, kTo, count);
  const auto colliders =
      tools::scene::make_colliders(scene, tools::scene::Granularity::instance, {});
  if (!colliders) return colliders.error();
  std::vector<std::uint32_t> frames(count);
  std::iota(frames.begin(), frames.end(), 0);
  const auto answers = ask_all({scene, *colliders, frames}, conditions);
  if (!answers) return answers.error();
  const std::string note = how_measured(
      "A case is a pair of creatures and the question whether they touch; means over " +
          std::to_string(count) + " cases, from " + shown(kFrom) + " units apart to " + shown(kTo) +
          ".",
      conditions);
  section.tables.push_back(image_table(
      *answers, note + " Images cover the intersection of the two boxes, so pixels are larger for "
                       "nearer pairs. The answer of Pelt is exact."));
  section.tables.push_back(rival_table(*answers, note));
  add_charts(section);
  return {};
}

}  // namespace pelt::reproduce
