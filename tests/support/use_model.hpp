#pragma once

#include <pelt/model.hpp>

namespace pelt::test {

/// Does with a model what a program would, whatever is in it: poses two instances, opens all their
/// nodes, collides them. Ends the program where a posed vertex is not finite or a contact names a
/// triangle that does not exist. True when the joint palettes were accepted.
bool use_model(const SkinnedModel& model);

}  // namespace pelt::test
