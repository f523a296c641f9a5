#pragma once

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

/// The methods of the command `pelt`.
inline constexpr std::array kCommandMethods = {kOnDemand, kEager, kPaper, kBrute};

}  // namespace pelt::methods
