#pragma once

/// Libraries that people use for what Pelt does, each behind the face of methods that start from
/// posed vertices: all do the same job on the same posed vertices, at the settings that suit
/// deforming meshes best.

#include "evaluation/rivals/posed_mesh_method.hpp"

#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace pelt::peers {

/// What a peer's answers are known to be, which tests confirm and `compare` counts.
enum class Answers {
  exact,   ///< the very pairs that intersect, in all that was tried
  nearly,  ///< pairs that all but touch may be missing or too many
  more,    ///< all pairs that intersect, and some that only come close
  fewer,   ///< pairs are missing
};

std::string_view name_of(Answers answers);

/// Who decides whether two triangles intersect.
enum class NarrowPhase {
  ours,    ///< Pelt's exact predicate, on candidates that the library supplies
  theirs,  ///< the library
};

struct Peer {
  std::string_view name;     ///< for make_peer
  std::string_view library;  ///< with what is used of it
  std::string version;       ///< of the library that this program runs with
  std::string_view update;   ///< what is done in each frame, in a word or two
  NarrowPhase narrow_phase = NarrowPhase::ours;
  Answers answers = Answers::exact;
};

std::span<const Peer> all_peers();

/// Null for a name that no peer has.
std::unique_ptr<rivals::PosedMeshMethod> make_peer(std::string_view name);

}  // namespace pelt::peers
