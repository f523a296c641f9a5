#pragma once

/// The methods of `pelt-lab bench` for a character against itself.

#include "tools/pelt/methods/self_methods.hpp"

namespace pelt::lab {

using methods::Method;
using methods::MethodKind;
using methods::Skins;

std::unique_ptr<Method> make_self_eager();

/// The simplest use of the library's tree: opens all nodes, queries the posed tree against itself
/// as if it were two characters, and decides pairs of neighbours, which always touch, one by one
/// with the exact predicate. Finds each pair twice.
inline constexpr MethodKind kSelfEager = {"eager", Skins::with_boxes, make_self_eager};

inline constexpr std::array kLabSelfMethods = {methods::kSelf, methods::kBoxes, kSelfEager,
                                               methods::kSelfBrute};

}  // namespace pelt::lab
