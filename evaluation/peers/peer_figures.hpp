#pragma once

/// What peers take for a scene and what they find, beside Pelt in the same run.
///
/// Measured as `pelt bench` measures (bench_measure.hpp). All peers start from vertices that are
/// skinned by Pelt's fastest code, which is measured as a method that does nothing else, and counts
/// as part of what each of them costs.

#include "evaluation/peers/compare.hpp"
#include "evaluation/peers/peers.hpp"
#include "tools/pelt/bench/bench_measure.hpp"

#include <ostream>
#include <string>
#include <vector>

namespace pelt::tools {

/// One method; times are microseconds a frame.
struct PeerFigures {
  std::string method, version, update, narrow_phase;
  double skinning_us = 0;     ///< of all vertices; 0 of Pelt's, which skin as they update or query
  double update_us = 0;       ///< what else is done before queries
  double all_us = 0;          ///< the query for all contacts
  double first_us = 0;        ///< the query for one of each pair of instances
  double frame_us = 0;        ///< all of it, for all contacts ...
  double first_frame_us = 0;  ///< ... and for one
  peers::Difference difference = {};  ///< from the exact answer, over all frames
};

struct ScenePeers {
  std::string scene;
  std::uint64_t triangles = 0;  ///< of all instances
  std::size_t frames = 0, frames_in_contact = 0;
  std::size_t contacts = 0;  ///< the exact answer, over all frames
  std::uint32_t repetitions = 0;
  std::vector<PeerFigures> methods;  ///< Pelt on demand, Pelt eager, then the peers
};

/// How often measure_peers calls `advance`.
std::size_t peer_steps(std::size_t frames);

/// Precondition: `subject` has frames.
Result<ScenePeers> measure_peers(const Subject& subject, std::uint32_t repetitions,
                                 const std::function<void()>& advance);

void print_peers(const ScenePeers& scene, std::ostream& out);

/// A row for each method of each scene.
void write_peers_csv(std::span<const ScenePeers> scenes, std::ostream& out);

}  // namespace pelt::tools
