#pragma once

/// Times and answers of peers for a scene, and of Pelt in the same run: for pairs of instances, or
/// for instances against themselves. How answers differ from the exact one.
///
/// Measured as by `pelt bench` (tools/pelt/bench/measure.hpp). All peers start from vertices that
/// Pelt's fastest code skins. This skinning is measured as a method of its own and counts as part
/// of the cost of each peer.

#include <pelt/collide.hpp>
#include <pelt/motion.hpp>

#include "tools/pelt/bench/measure.hpp"

#include <cstddef>
#include <ostream>
#include <span>
#include <string>
#include <vector>

namespace pelt::peers {

/// Difference between an answer and the exact one.
struct Difference {
  std::size_t missing = 0;   ///< exact contacts that the answer lacks
  std::size_t extra = 0;     ///< pairs in the answer that do not intersect
  std::size_t repeated = 0;  ///< contacts that occur earlier in the answer

  Difference& operator+=(const Difference& other);
  friend bool operator==(const Difference&, const Difference&) = default;
};

/// Compares sets: the order of the contacts does not matter.
Difference compare(std::span<const Contact> answer, std::span<const Contact> exact);

/// Difference between contacts of a step and the exact ones.
struct MovingDifference {
  std::size_t missing_at_start = 0;  ///< exact contacts that intersect at time 0, and are missing
  std::size_t missing_later = 0;     ///< exact contacts that first intersect later, and are missing
  std::size_t extra = 0;             ///< pairs that never intersect
  std::size_t early = 0;             ///< times that are earlier than the exact ones ...
  std::size_t late = 0;              ///< ... or later, by more than kTimeTolerance

  MovingDifference& operator+=(const MovingDifference& other);
  friend bool operator==(const MovingDifference&, const MovingDifference&) = default;
};

inline constexpr float kTimeTolerance = 1e-4f;

/// Compares sets. Times of contacts that intersect at time 0 are not compared. Precondition: both
/// are ascending.
MovingDifference compare_moving(std::span<const MovingContact> answer,
                                std::span<const MovingContact> exact);

}  // namespace pelt::peers

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

/// One method; times are in microseconds per frame.
struct PeerFigures {
  std::string method, version, update, narrow_phase;
  double skinning_us = 0;             ///< skinning all vertices; 0 for Pelt, which skins later
  double update_us = 0;               ///< other work before queries
  double all_us = 0;                  ///< the query for all contacts
  double first_us = 0;                ///< the query for one of each pair of instances
  double frame_us = 0;                ///< total for all contacts
  double first_frame_us = 0;          ///< total for one contact of each pair
  peers::Difference difference = {};  ///< from the exact answer, over all frames
};

struct ScenePeers {
  std::string scene;
  Contest contest = Contest::pairs;
  std::uint64_t triangles = 0;  ///< of all instances
  std::size_t frames = 0, frames_in_contact = 0;
  std::size_t contacts = 0;  ///< the exact answer, over all frames
  std::uint32_t repetitions = 0;
  std::vector<PeerFigures> methods;  ///< Pelt on demand or self, Pelt eager, then the peers
};

/// Cost of a method over that of the first one, for all contacts. For pairs, the cost of skinning
/// counts for all. For instances against themselves, it only counts for Pelt's methods, because
/// libraries for self-intersections start from meshes.
double cost_over_pelt(const ScenePeers& scene, const PeerFigures& figures);

/// Number of times that measure_peers calls `advance`.
std::size_t peer_steps(std::size_t frames, Contest contest = Contest::pairs);

/// Precondition: `subject` has at least one frame.
Result<ScenePeers> measure_peers(const bench::Subject& subject, std::uint32_t repetitions,
                                 const std::function<void()>& advance,
                                 Contest contest = Contest::pairs);

void print_peers(const ScenePeers& scene, std::ostream& out);

/// Writes one row for each method of each scene.
void write_peers_csv(std::span<const ScenePeers> scenes, std::ostream& out);

}  // namespace pelt::tools
