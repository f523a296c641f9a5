#include "bindings/wasm/engine/words.hpp"

#include <cstddef>
#include <string_view>

namespace pelt::wasm {
namespace {

struct Words {
  std::string_view in_code, in_javascript;
};

/// A phrase comes before those that it contains.
constexpr Words kWords[] = {
    {"off_weights = OffWeights::renormalise", "renormalise: true"},
    {"ModelOptions::weld = false", "weld: false"},
    {"ModelOptions::skinning = Skinning::dual_quaternion", "skinning: 'dual-quaternion'"},
    {"dual_quaternions[", "dualQuaternions["},
    {"SkinnedMeshView::offset_caps", "offsetCaps"},
    {"offset_caps", "offsetCaps"},
    {"rest_positions", "restPositions"},
    {"set_palette", "setPalette"},
};

}  // namespace

Error in_words_of_javascript(Error error) {
  for (const auto& [in_code, in_javascript] : kWords)
    if (const std::size_t at = error.message.find(in_code); at != error.message.npos)
      error.message.replace(at, in_code.size(), in_javascript);
  return error;
}

}  // namespace pelt::wasm
