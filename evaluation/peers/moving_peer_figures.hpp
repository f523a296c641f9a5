#pragma once

/// Times and answers of continuous collision detection in other libraries for the steps of a scene,
/// and of Pelt in the same run. Measured as by `pelt-lab bench --moving`. Peers start from vertices
/// that Pelt's fastest code skins, which counts as part of their cost.

#include "evaluation/bench/moving_bench.hpp"
#include "evaluation/peers/adapters.hpp"
#include "evaluation/peers/peer_figures.hpp"

#include <ostream>
#include <string>
#include <vector>

namespace pelt::tools {

/// Skins all vertices for every new palette, and calls `method`.
std::unique_ptr<lab::MovingMethod> adapt_moving(std::unique_ptr<peers::MovingMeshMethod> method);

/// One method; times are in microseconds per step.
struct MovingPeerFigures {
  std::string method;
  double skinning_us = 0;  ///< skinning all vertices; 0 for Pelt, which skins later
  double update_us = 0;    ///< other work before queries
  double query_us = 0;     ///< the query for all pairs of triangles, with times
  double step_us = 0;      ///< total
  peers::MovingDifference difference = {};  ///< from the exact answer, over all steps
};

struct MovingScenePeers {
  std::string scene;
  std::uint64_t triangles = 0;  ///< of all instances
  std::size_t steps = 0, steps_in_contact = 0;
  std::size_t contacts = 0, contacts_at_start = 0;  ///< the exact answer, over all steps
  std::uint32_t repetitions = 0;
  std::vector<MovingPeerFigures> methods;  ///< Pelt on demand, Pelt eager, then the peers
};

/// Precondition: `subject` has at least one step.
Result<MovingScenePeers> measure_moving_peers(const lab::MovingSubject& subject,
                                              std::uint32_t repetitions);

void print_moving_peers(const MovingScenePeers& scene, std::ostream& out);

}  // namespace pelt::tools
