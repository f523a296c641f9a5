#pragma once

#include <pelt/model.hpp>

namespace pelt::test {

/// Uses a model as a program would, whatever its content: poses two instances, opens all their
/// nodes, collides them. Ends the program if a posed vertex is not finite or a contact has an
/// invalid triangle number. Returns true if the joint palettes were accepted.
bool use_model(const SkinnedModel& model);

}  // namespace pelt::test
