#include "tools/pelt/arguments/simd_argument.hpp"

#include <pelt/target.hpp>

#include "asset/message.hpp"
#include "tools/pelt/output/text.hpp"

#include <algorithm>
#include <array>

namespace pelt::tools::arguments {
namespace {

constexpr std::array kTargets = {Target::scalar, Target::simd128, Target::avx2};

std::string available_names() {
  std::string names;
  for (const Target target : available_targets())
    names += (names.empty() ? "" : " or ") + std::string(name_of(target));
  return names;
}

}  // namespace

void add_simd_option(Verb& verb, std::string& name) {
  verb.option("--simd", name,
              "Instruction set for queries; does not change answers (default: the fastest that the "
              "processor supports)",
              {.type = "scalar|simd128|avx2"});
}

Result<void> choose_simd(const std::string& name) {
  if (name.empty()) return {};
  const auto target = std::find_if(kTargets.begin(), kTargets.end(),
                                   [&](Target known) { return name == name_of(known); });
  const bool is_known = target != kTargets.end();
  if (is_known && set_active_target(*target)) return {};
  return output::bad_argument("--simd",
                              is_known ? name + " is not supported by this processor"
                                       : "unknown value " + asset::quoted(name),
                              "give " + available_names());
}

}  // namespace pelt::tools::arguments
