#pragma once

#include "evaluation/rivals/posed_mesh_method.hpp"
#include "tools/pelt/methods/method.hpp"

namespace pelt::lab {

/// Adapts a method that starts from posed vertices. For every new palette, the adapter skins all
/// vertices with the library's fastest code. This time counts as part of the method's cost.
std::unique_ptr<methods::Method> adapt(std::unique_ptr<rivals::PosedMeshMethod> method);

}  // namespace pelt::lab
