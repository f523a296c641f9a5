#pragma once

/// Libraries that people use for the same purpose as Pelt, with the interface of methods that start
/// from posed vertices. All get the same posed vertices, and the settings that suit deforming
/// meshes best.

#include "evaluation/rivals/posed_mesh_method.hpp"

#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace pelt::peers {

/// Known quality of a peer's answers. Tests confirm it, and `compare` counts the differences.
enum class Answers {
  exact,  ///< exactly the pairs that intersect, in all that was tried
  more,   ///< all pairs that intersect, and some that only come close
  fewer,  ///< pairs are missing
};

/// Decides whether two triangles intersect.
enum class NarrowPhase {
  ours,    ///< Pelt's exact predicate, on candidates that the library supplies
  theirs,  ///< the library
};

struct Peer {
  std::string_view name;     ///< for make_peer
  std::string_view library;  ///< and the part of it that is used
  std::string version;       ///< of the library at run time
  std::string_view update;   ///< the work in each frame, in a word or two
  NarrowPhase narrow_phase = NarrowPhase::ours;
  Answers answers = Answers::exact;
};

std::span<const Peer> all_peers();

/// Null if no peer has this name.
std::unique_ptr<rivals::PosedMeshMethod> make_peer(std::string_view name);

/// The same for a body against itself; see adapters.hpp.
std::span<const Peer> all_self_peers();
std::unique_ptr<rivals::PosedMeshMethod> make_self_peer(std::string_view name);

}  // namespace pelt::peers
