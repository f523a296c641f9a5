#pragma once

/// Spatial hashing (hash.hpp) as its authors mean it: one grid for all bodies. The first question
/// after an update finds the contacts of all of them: body after body, its triangles are looked up
/// among those of the bodies before it, then entered. Triangles outside all other bodies' boxes are
/// left out. No pair of bodies is asked for by itself, and
/// nothing need be known of which are near. Limits are kept, but save little.
/// Precondition of a question: all bodies have been updated.

#include "evaluation/rivals/hash.hpp"

namespace pelt::rivals {

std::unique_ptr<PosedMeshMethod> make_hash_crowd(const HashOptions& options = {});

}  // namespace pelt::rivals
