#pragma once

#include "tools/pelt/bench/bench_engine.hpp"

#include <vector>

namespace pelt::tools::bench {

/// Answers of an engine to one query, with each frame queried once.
struct Answer {
  std::uint64_t hash = 0;  ///< all: of all contacts, see ContactHash; first: FNV-1a 64 over u32
                           ///< frame, a, b, whether they touch (0 or 1), of all pairs queried
  QueryStats work;         ///< work of posing and querying
  std::uint64_t frames_in_contact = 0;
  std::uint64_t contacts = 0;  ///< found in all frames
};

/// The answers [questions] of an engine, for comparison with others. Times nothing.
Result<std::vector<Answer>> answer(const Subject& subject, const Engine& engine,
                                   std::span<const Question> questions);

}  // namespace pelt::tools::bench
