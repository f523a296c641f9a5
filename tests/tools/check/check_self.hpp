#pragma once

/// Runs `pelt check` of characters against themselves.

#include "support/gltf_builder.hpp"
#include "tools/answer.hpp"

#include <string>
#include <vector>

namespace pelt::test {

using CommandWords = std::vector<std::string>;

inline CommandWords self_words(CommandWords words, const CommandWords& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

inline CheckFile check_self(const TestFolder& folder, const CommandWords& more, int exit_code) {
  const Ended run =
      run_pelt(folder, self_words({"check"}, self_words(more, {"--pairs", "--jsonl", "-"})));
  EXPECT_EQ(run.exit_code, exit_code) << run.err;
  return parse_check_file(run.out);
}

/// The contacts of instance `a` with instance `b` in a frame's line.
inline json triangles_of(const json& line, std::uint32_t a, std::uint32_t b) {
  for (const json& pair : line["pairs"])
    if (pair["a"] == a && pair["b"] == b) return pair["triangles"];
  return json::array();
}

inline const CommandWords kKeepAll = {"--self-at-rest", "keep", "--self-near-joints", "keep"};

}  // namespace pelt::test
