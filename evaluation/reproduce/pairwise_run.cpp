#include "evaluation/reproduce/pairwise_run.hpp"

#include "base/assert.hpp"
#include "tools/pelt/bench/stopwatch.hpp"
#include "tools/pelt/output/statistics.hpp"

namespace pelt::reproduce {

PairwiseRun::PairwiseRun(const programs::CrowdJob& job, methods::MethodKind method)
    : job_(job), method_(method.make()) {
  for (const SkinnedModel& model : job.models) method_->add(model);
}

PairwiseTiming PairwiseRun::run() {
  std::vector<double> times;
  for (std::uint32_t frame = 0; frame < job_.frame_count; ++frame) {
    job_.pose(frame, palettes_);
    contacts_.clear();
    tools::bench::Stopwatch watch;
    set_palettes();
    collide_pairs();
    watch.stop();
    times.push_back(watch.microseconds());
  }
  return {tools::output::median(times), contacts_.size()};
}

void PairwiseRun::set_palettes() {
  std::span<const Matrix4> rest = palettes_;
  for (std::uint32_t body = 0; body < job_.models.size(); ++body) {
    const std::uint32_t joints = job_.models[body].joint_count();
    const Result<void> taken = method_->set_palette(body, rest.first(joints));
    PELT_ASSERT(taken);
    rest = rest.subspan(joints);
  }
}

void PairwiseRun::collide_pairs() {
  for (std::uint32_t a = 0; a < job_.models.size(); ++a)
    for (std::uint32_t b = a + 1; b < job_.models.size(); ++b)
      method_->collide(a, b, contacts_, {});
}

}  // namespace pelt::reproduce
