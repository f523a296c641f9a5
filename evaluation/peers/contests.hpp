#pragma once

/// Which methods are compared, for pairs of instances and for instances against themselves.

#include "tools/pelt/bench/runner.hpp"

#include <string>
#include <vector>

namespace pelt::tools {

enum class Contest {
  pairs,  ///< every pair of instances
  self,   ///< each instance against itself
};

/// A method that is compared, and how it is described.
struct Contestant {
  bench::BenchMethod method;
  std::string name, version, update, narrow_phase;
  bool is_ours = false;  ///< skins during its update or query
};

/// Pelt's methods, then the peers.
std::vector<Contestant> contestants(Contest contest);

/// Skins all vertices, which every peer needs, and finds nothing.
bench::BenchMethod skinning_method();

/// Brute force, the exact answer.
bench::BenchMethod exact_method(Contest contest);

}  // namespace pelt::tools
