#include "tools/pelt/methods/paper_method.hpp"

#include "tools/pelt/methods/command_methods.hpp"

namespace pelt::methods {

std::unique_ptr<Method> make_paper() {
  return std::make_unique<BodyMethod<PaperTraits<paper::BoundKind::optimised>>>();
}

}  // namespace pelt::methods
