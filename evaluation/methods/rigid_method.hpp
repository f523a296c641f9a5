#pragma once

#include "evaluation/methods/method.hpp"

namespace pelt::bench {

/// The yardstick: what the same query costs rigid bodies. For each palette the tree is built afresh
/// over the posed mesh, and all is opened with exact boxes; a query then has no more to do than one
/// between rigid bodies. The last two palettes of a body are remembered, so that going to and fro
/// between two frames builds nothing.
std::unique_ptr<Method> make_rigid_method();

}  // namespace pelt::bench
