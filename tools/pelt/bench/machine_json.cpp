#include "tools/pelt/bench/machine_json.hpp"

#include <pelt/version.hpp>

#include "tools/pelt/bench/machine.hpp"

namespace pelt::tools::bench {

nlohmann::ordered_json machine_json() {
  const Machine machine = this_machine();
  return {{"cpu", machine.cpu},
          {"cores", machine.cores},
          {"instruction_set", machine.instruction_set},
          {"compiler", machine.compiler},
          {"build", machine.build},
          {"flags", machine.flags},
          {"pelt", PELT_VERSION}};
}

}  // namespace pelt::tools::bench
