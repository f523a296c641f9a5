#pragma once

/// The methods of the command `pelt`: of --method, and of `pelt bench`.

#include "tools/pelt/methods/method.hpp"

#include <array>

namespace pelt::methods {

std::unique_ptr<Method> make_on_demand();
std::unique_ptr<Method> make_eager();
std::unique_ptr<Method> make_paper();
std::unique_ptr<Method> make_brute();

/// The public functions: wide tree, nodes opened on demand.
inline constexpr MethodKind kOnDemand = {"on_demand", Skins::where_queried, make_on_demand};

/// The same tree, wide code and query, but every new palette skins all vertices and computes all
/// boxes bottom-up: the best alternative to refitting on demand that we can make. Its boxes are
/// exact, so its queries visit fewer pairs.
inline constexpr MethodKind kEager = {"eager", Skins::with_boxes, make_eager};

/// Kavan & Zara 2005, the system that this project started from: a sphere tree refitted on demand.
inline constexpr MethodKind kPaper = {"paper", Skins::where_queried, make_paper};

/// Tests every triangle of one body against every triangle of the other.
inline constexpr MethodKind kBrute = {"brute", Skins::first, make_brute};

inline constexpr std::array kCommandMethods = {kOnDemand, kEager, kPaper, kBrute};

/// The methods for a character against itself. `Method::collide` is called with the same body
/// twice, and finds the pairs of triangles that self_collide defines, without filters.
std::unique_ptr<Method> make_self();
std::unique_ptr<Method> make_boxes();
std::unique_ptr<Method> make_self_brute();

/// The public function self_collide.
inline constexpr MethodKind kSelf = {"self", Skins::with_boxes, make_self};

/// Skins all vertices and computes all boxes bottom-up, and finds nothing: the unit of comparison.
inline constexpr MethodKind kBoxes = {"boxes", Skins::with_boxes, make_boxes};

/// The oracle: tests all pairs whose boxes overlap with the exact predicate, without a tree.
inline constexpr MethodKind kSelfBrute = {"brute", Skins::first, make_self_brute};

inline constexpr std::array kSelfMethods = {kSelf, kBoxes, kSelfBrute};

}  // namespace pelt::methods
