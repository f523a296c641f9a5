#pragma once

#include "tools/pelt/bench/bench_method.hpp"

#include <vector>

namespace pelt::tools::bench {

/// Answers of a method to one query, with each frame queried once.
struct Answer {
  std::uint64_t hash = 0;  ///< all: of all contacts, see ContactHash; first: FNV-1a 64 over u32
                           ///< frame, a, b, whether they touch (0 or 1), of all pairs queried
  QueryStats work;         ///< work of posing and querying
  std::uint64_t frames_in_contact = 0;
  std::uint64_t contacts = 0;  ///< found in all frames
};

/// The answers [questions] of a method, for comparison with others. Times nothing.
Result<std::vector<Answer>> answer(const Subject& subject, const BenchMethod& method,
                                   std::span<const Question> questions);

}  // namespace pelt::tools::bench
