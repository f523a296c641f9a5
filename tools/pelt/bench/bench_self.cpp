#include "tools/pelt/bench/bench_self.hpp"

#include <pelt/self_filter.hpp>

#include "tools/pelt/bench/stopwatch.hpp"

#include <set>

namespace pelt::tools::bench {

Result<SelfFilterFigures> measure_self_filters(std::span<const scene::Collider> colliders) {
  SelfFilterFigures figures;
  std::set<const detail::Model*> counted;
  for (const scene::Collider& collider : colliders) {
    if (!counted.insert(&collider.model.detail()).second) continue;
    Stopwatch watch;
    const Result<SelfFilter> filter = build_self_filter(collider.model);
    watch.stop();
    if (!filter) return filter.error();
    figures.bytes += filter->memory_bytes();
    figures.build_seconds += watch.microseconds() * 1e-6;
  }
  return figures;
}

}  // namespace pelt::tools::bench
