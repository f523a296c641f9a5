#pragma once

/// The tables of the section on self-collision.

#include <pelt/result.hpp>
#include <pelt/self_filter.hpp>

#include "evaluation/reproduce/report.hpp"
#include "scenes/scene.hpp"

#include <span>

namespace pelt::reproduce {

/// Parts of `self_collide`, in microseconds per frame. They are measured in separate runs, so that
/// the library contains no clocks.
struct SelfStages {
  double open_us = 0;            ///< skinning, boxes of nodes and clusters
  double triangle_boxes_us = 0;  ///< boxes of triangles, computed
  double descent_us = 0;         ///< down to overlapping clusters
  double fans_us = 0;            ///< pairs that share a surface vertex
  double all_us = 0;             ///< the whole query, with the palette

  /// The rest: pairs of clusters. Boxes of triangles are compared, and triangles tested.
  double cluster_pairs_us() const {
    return all_us - open_us - triangle_boxes_us - descent_us - fans_us;
  }
};

/// Measures the only instance of a scene on at most `most_frames` evenly spaced frames.
Result<SelfStages> measure_self_stages(const scenes::Scene& scene, std::uint32_t most_frames,
                                       const Conditions& conditions);

/// One instance of a character that plays the clip "walk", or its first clip.
scenes::Scene lone_walker(const scenes::Character& character);

/// Walking creatures with these numbers of triangles: "self_growth", with the column "triangles".
Result<Table> self_growth(std::span<const std::uint32_t> triangles, const Conditions& conditions);

/// The exponents with which contacts and times of `self_growth` grow: "self_exponents".
Table self_exponents(const Table& growth);

/// How the time of each character splits: "self_stages".
Result<Table> self_stage_table(std::span<const scenes::Character> characters,
                               const Conditions& conditions);

}  // namespace pelt::reproduce
