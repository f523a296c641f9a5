#pragma once

/// Objects that JavaScript refers to by address.

#include <pelt/pose.hpp>
#include <pelt/self_filter.hpp>
#include <pelt/surface.hpp>

#include "collide/eager.hpp"
#include "scenes/scene.hpp"

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace pelt::wasm {

/// Options for preparing a character.
struct Preparation {
  std::vector<const asset::Clip*> clips;  ///< sources of sample poses
  std::uint32_t samples = 6;
  bool renormalise = false;
  bool weld = true;
  std::vector<float> offset_caps;    ///< [V] or empty
  std::optional<Skinning> skinning;  ///< nothing: as the scene says, or linear
};

/// A character, or one part of it, prepared for queries.
struct Body {
  SkinnedModel model;
  std::uint32_t first_triangle = 0;  ///< the first triangle's number in the character
};

/// Part number that means the whole character.
inline constexpr std::uint32_t kWhole = 0xFFFFFFFF;

/// A character that has been prepared for queries.
struct Character {
  scenes::Character read;
  Preparation preparation;
  Body whole;
  std::vector<std::unique_ptr<Body>> parts;  ///< created on first use, like the next member
  std::vector<std::uint32_t> seams;          ///< see get_seams

  const asset::Asset& asset() const { return read.asset; }

  /// Returns for each vertex the representative of all bit-identical vertices: exporters split
  /// vertices where a texture has a seam.
  const std::vector<std::uint32_t>& get_seams();

  /// Returns the whole character or one part. Returns an error for a part without triangles.
  Result<Body*> body(std::uint32_t part);
};

struct CharacterHandle {
  std::shared_ptr<Character> character;
};

/// Prepares a character like `pelt check`. Error messages start with the character's source.
Result<CharacterHandle> prepare(scenes::Character read, Preparation preparation);

struct PoseHandle {
  PoseHandle(std::shared_ptr<Character> owner, Body& posed)
      : character(std::move(owner)), body(posed), pose(posed.model) {}

  std::shared_ptr<Character> character;
  Body& body;  ///< of the character
  Pose pose;
  std::vector<Vec3> offsets;               ///< borrowed by the pose
  std::vector<Vec3> vertices, normals;     ///< read by JavaScript
  std::optional<detail::EagerPose> eager;  ///< for collideEagerly
  std::optional<Pose> whole;               ///< all nodes opened, for nodeBoxes
  bool has_vertices = false;               ///< whether `vertices` is up to date
  bool is_refitted = false;                ///< whether `eager` is up to date

  /// Call after the palette or the weights have changed.
  void moved() { has_vertices = is_refitted = false; }
};

/// A filter of a character or of one of its parts.
struct FilterHandle {
  std::shared_ptr<Character> character;
  SelfFilter filter;
};

/// Converts pairs to the characters' triangle numbers, and answers with them. `first_a` and
/// `first_b` are the numbers of the bodies' first triangles.
void answer_pairs(std::vector<Contact>& pairs, std::uint32_t first_a, std::uint32_t first_b);

/// Working memory shared by all queries.
Scratch& scratch();
asset::SampleScratch& sample_scratch();

}  // namespace pelt::wasm
