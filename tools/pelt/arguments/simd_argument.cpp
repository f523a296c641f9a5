#include "tools/pelt/arguments/simd_argument.hpp"

#include <pelt/config.hpp>

#include "asset/message.hpp"
#include "tools/pelt/output/text.hpp"

#include <algorithm>
#include <array>

namespace pelt::tools::arguments {
namespace {

constexpr std::array kInstructionSets = {InstructionSet::scalar, InstructionSet::simd128,
                                         InstructionSet::avx2};

std::string available_names() {
  std::string names;
  for (const InstructionSet set : available_instruction_sets())
    names += (names.empty() ? "" : " or ") + std::string(name_of(set));
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
  const auto set = std::find_if(kInstructionSets.begin(), kInstructionSets.end(),
                                [&](InstructionSet known) { return name == name_of(known); });
  const bool is_known = set != kInstructionSets.end();
  if (is_known && set_active_instruction_set(*set)) return {};
  return output::bad_argument("--simd",
                              is_known ? name + " is not supported by this processor"
                                       : "unknown value " + asset::quoted(name),
                              "give " + available_names());
}

}  // namespace pelt::tools::arguments
