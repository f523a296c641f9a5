#pragma once

/// The tables of the section on self-collision.

#include "evaluation/reproduce/experiment.hpp"
#include "scenes/scene.hpp"

#include <span>
#include <vector>

namespace pelt::reproduce {

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
