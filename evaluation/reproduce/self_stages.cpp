#include "evaluation/reproduce/self_stages.hpp"

#include <pelt/self.hpp>

#include "collide/eager.hpp"
#include "evaluation/rivals/tree_stages.hpp"
#include "model/model.hpp"
#include "self/self_filter.hpp"
#include "tools/pelt/bench/stopwatch.hpp"
#include "tools/pelt/output/statistics.hpp"
#include "tools/pelt/scene/collider_palettes.hpp"
#include "tools/pelt/scene/colliders.hpp"

#include <algorithm>
#include <array>

namespace pelt::reproduce {
namespace {

/// The filter without fans: the query then finds only pairs that share no surface vertex.
SelfFilter without_fans(const SelfFilter& filter) {
  const auto copy = std::make_shared<detail::SelfFilter>(filter.detail());
  copy->fans.runs.clear();
  return SelfFilter(copy);
}

template <typename Work>
double time_us(const Work& work) {
  tools::bench::Stopwatch watch;
  work();
  watch.stop();
  return watch.microseconds();
}

/// One character, and the memory of its queries.
class StageRun {
 public:
  StageRun(const SkinnedModel& model, const SelfFilter& filter)
      : pose_(model),
        exact_(model.detail().tree),
        filter_(filter),
        without_fans_(reproduce::without_fans(filter)) {}

  /// Times all stages once, on a pose that differs from the last one.
  Result<void> repeat(std::span<const Matrix4> palette) {
    if (const auto taken = exact_.set_palette(palette); !taken) return taken;
    add(0, [&] { exact_.open_all(); });
    const detail::PosedTree posed = exact_.posed_tree();
    const detail::PairMasks& masks = filter_.detail().masks;
    add(1, [&] { rivals::active_box_all_triangles()(posed, masks, tree_scratch_); });
    add(2, [&] { rivals::active_descend_self()(posed, masks); });
    const double without_fans_us = query_us(palette, without_fans_);
    times_[4].push_back(query_us(palette, filter_));
    times_[3].push_back(std::max(0.0, times_[4].back() - without_fans_us));
    return {};
  }

  /// Ends a frame: the medians of its repetitions.
  void end_frame() {
    for (std::size_t stage = 0; stage < times_.size(); ++stage) {
      frames_[stage].push_back(tools::output::median(times_[stage]));
      times_[stage].clear();
    }
  }

  SelfStages means() const {
    const auto mean = [&](std::size_t stage) { return tools::output::mean(frames_[stage]); };
    return {mean(0), mean(1), mean(2), mean(3), mean(4)};
  }

 private:
  template <typename Work>
  void add(std::size_t stage, const Work& work) {
    times_[stage].push_back(time_us(work));
  }

  double query_us(std::span<const Matrix4> palette, const SelfFilter& filter) {
    contacts_.clear();
    return time_us([&] {
      static_cast<void>(pose_.set_palette(palette));
      self_collide(pose_, filter, scratch_, contacts_);
    });
  }

  Pose pose_;
  detail::EagerPose exact_;
  SelfFilter filter_, without_fans_;
  Scratch scratch_;
  detail::Scratch tree_scratch_;
  std::vector<Contact> contacts_;
  std::array<std::vector<double>, 5> times_, frames_;
};

}  // namespace

Result<SelfStages> measure_self_stages(const scenes::Scene& scene, std::uint32_t most_frames,
                                       const Conditions& conditions) {
  const auto colliders =
      tools::scene::make_colliders(scene, tools::scene::Granularity::instance, {});
  if (!colliders) return colliders.error();
  const SkinnedModel& model = colliders->front().model;
  const Result<SelfFilter> filter = build_self_filter(model);
  if (!filter) return filter.error();
  StageRun run(model, *filter);
  asset::SampleScratch scratch;
  tools::scene::Palettes palettes;
  const std::uint32_t most = conditions.is_quick ? std::max(most_frames / 4, 1u) : most_frames;
  const std::uint32_t step = (scene.frame_count + most - 1) / most;
  for (std::uint32_t frame = 0; frame < scene.frame_count; frame += step) {
    tools::scene::sample_palettes(scene, frame, scratch, palettes);
    for (std::uint32_t r = 0; r < (conditions.is_quick ? 3u : 9u); ++r)
      if (const auto done = run.repeat(palettes[0]); !done) return done.error();
    run.end_frame();
  }
  return run.means();
}

}  // namespace pelt::reproduce
