#pragma once

#include "evaluation/rivals/posed_mesh_method.hpp"
#include "tools/pelt/methods/method.hpp"

namespace pelt::methods {

/// A method that starts from posed vertices, given all of them at every new palette: as fast as the
/// library skins, and counted as part of what the method costs.
std::unique_ptr<Method> adapt(std::unique_ptr<rivals::PosedMeshMethod> method);

}  // namespace pelt::methods
