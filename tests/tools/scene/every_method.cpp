#include "tools/scene/every_method.hpp"

#include "tools/pelt/methods/command_methods.hpp"

namespace pelt::test {

methods::MethodKinds every_method() { return methods::kCommandMethods; }

}  // namespace pelt::test
