#pragma once

/// What the queries of a check find in one frame. Answers do not depend on each other, so frames
/// can be queried in any order, on any thread and in any process.

#include <pelt/query.hpp>
#include <pelt/self_filter.hpp>

#include "tools/pelt/check/between_query.hpp"
#include "tools/pelt/check/budget_query.hpp"
#include "tools/pelt/check/inside_query.hpp"
#include "tools/pelt/check/patch_tally.hpp"
#include "tools/pelt/scene/scene_query.hpp"

#include <optional>
#include <string>
#include <vector>

namespace pelt::tools::check {

struct FrameAnswer {
  std::uint32_t frame = 0;
  scene::FrameContacts found;           ///< the contacts that count
  std::uint64_t ignored = 0;            ///< contacts that do not count
  LeftOut left_out;                     ///< contacts of bodies with themselves that do not count
  std::vector<Undecided> undecided;     ///< with --budget
  std::vector<InsidePair> inside;       ///< with --inside
  std::vector<DescribedPatch> patches;  ///< with --contacts
  std::optional<StepAnswer> step;       ///< with --between: the step that ends with the frame
  std::string line;                     ///< of --jsonl, without the end of the line
  QueryStats work;                      ///< without that of the step
  double seconds = 0;  ///< setting palettes and querying contacts, without sampling
};

}  // namespace pelt::tools::check
