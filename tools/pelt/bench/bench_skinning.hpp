#pragma once

#include "tools/pelt/bench/bench_method.hpp"

namespace pelt::tools::bench {

/// The time to pose all vertices of all instances with the wide code, as a unit for comparing
/// methods.
struct Skinning {
  std::uint64_t vertices = 0;  ///< of all instances
  double mean_us = 0;          ///< per frame

  double ns_per_vertex() const { return 1000 * mean_us / static_cast<double>(vertices); }
};

/// The mean over the frames of the medians of the repetitions.
Result<Skinning> measure_skinning(const Subject& subject, std::uint32_t repetitions);

}  // namespace pelt::tools::bench
