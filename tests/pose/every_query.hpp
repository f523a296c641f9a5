#pragma once

/// Every query of two bodies that move, as one hash of the answers for each kind of query.

#include <pelt/pelt.hpp>

#include <cstdint>
#include <map>
#include <string>

namespace pelt::test {

/// Both poses of two motions.
struct Stage {
  Pose a_from, a, b_from, b;
};

struct Answers {
  std::map<std::string, std::uint64_t> hashes;  ///< by the kind of query
  std::map<std::string, std::uint64_t> found;   ///< how much each of them found
};

/// Asks about fixed points, rays, regions and fields of a size of about one. The answers do not
/// include the work. Bounds are exact.
Answers ask_every_query(Stage& stage, Scratch& scratch);

}  // namespace pelt::test
