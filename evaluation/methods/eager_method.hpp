#pragma once

#include "evaluation/methods/method.hpp"

namespace pelt::bench {

/// The rival of refit on demand, as good as we can make it: the same tree, the same wide code and
/// the same query, but every new palette skins all vertices and takes all boxes bottom-up. Its
/// boxes are exact, so that its queries meet fewer pairs.
std::unique_ptr<Method> make_eager_method();

}  // namespace pelt::bench
