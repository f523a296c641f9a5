#pragma once

/// The expected answer of `pelt check`: all pairs of triangles, by the exact predicate.

#include "tools/pelt/methods/brute_force.hpp"
#include "tools/pelt/scene/scene_glb.hpp"
#include "tools/run_program.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace pelt::test {

/// The lines of a pelt-check file.
struct CheckFile {
  nlohmann::json header, totals;
  std::vector<nlohmann::json> frames;
};

inline CheckFile parse_check_file(const std::string& text) {
  CheckFile file;
  const std::vector<std::string> lines = lines_of(text);
  EXPECT_GE(lines.size(), 2u);
  for (const std::string& line : lines) file.frames.push_back(nlohmann::json::parse(line));
  file.header = file.frames.front();
  file.totals = file.frames.back();
  file.frames.erase(file.frames.begin());
  file.frames.pop_back();
  return file;
}

/// The lines of JSON that a verb writes. Expects this exit code.
inline CheckFile answer_of(const TestFolder& folder, int exit_code, const Words& words) {
  return parse_check_file(run_pelt(folder, exit_code, joined(words, {"--jsonl", "-"})).out);
}

/// The answer of `pelt check` with the triangles of all contacts.
inline CheckFile check_pairs(const TestFolder& folder, int exit_code, const Words& options) {
  return answer_of(folder, exit_code, joined({"check", "--pairs"}, options));
}

/// Contacts between two ranges of triangles of two instances, as JSON.
inline nlohmann::json brute_force_json(const tools::scene::PosedInstance& a,
                                       const tools::scene::PosedInstance& b) {
  std::vector<Contact> contacts;
  methods::brute_force_collide(a.triangles, a.positions, b.triangles, b.positions, contacts,
                               std::numeric_limits<std::uint32_t>::max());
  nlohmann::json triangles = nlohmann::json::array();
  for (const Contact& contact : contacts) {
    triangles.push_back({contact.triangle_a, contact.triangle_b});
  }
  return triangles;
}

/// The hash as documented, from the triangle lists of a file.
inline std::string hash_of(const CheckFile& file) {
  std::uint64_t state = 14695981039346656037u;
  const auto add = [&](std::uint32_t value) {
    for (int byte = 0; byte < 4; ++byte) {
      state ^= value & 255;
      state *= 1099511628211u;
      value >>= 8;
    }
  };
  for (const nlohmann::json& frame : file.frames) {
    for (const nlohmann::json& pair : frame["pairs"]) {
      for (const nlohmann::json& triangles : pair["triangles"]) {
        add(frame["frame"]);
        add(pair["a"]);
        add(pair["b"]);
        add(triangles[0]);
        add(triangles[1]);
      }
    }
  }
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(state));
  return text;
}

/// The lines of steps, which are removed from the frames.
inline std::vector<nlohmann::json> take_steps(CheckFile& file) {
  const auto steps =
      std::stable_partition(file.frames.begin(), file.frames.end(),
                            [](const nlohmann::json& line) { return line.contains("frame"); });
  std::vector<nlohmann::json> lines(steps, file.frames.end());
  file.frames.erase(steps, file.frames.end());
  return lines;
}

}  // namespace pelt::test
