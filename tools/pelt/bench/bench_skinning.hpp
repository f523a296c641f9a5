#pragma once

#include "tools/pelt/bench/bench_engine.hpp"

namespace pelt::tools {

/// The unit that engines are compared with: all vertices of all instances posed by the wide code.
struct Skinning {
  std::uint64_t vertices = 0;  ///< of all instances
  double mean_us = 0;          ///< a frame, all of them

  double ns_per_vertex() const { return 1000 * mean_us / static_cast<double>(vertices); }
};

/// Per frame the median of the repetitions, then the mean over the frames.
Result<Skinning> measure_skinning(const Subject& subject, std::uint32_t repetitions);

}  // namespace pelt::tools
