#pragma once

#include <nlohmann/json.hpp>

namespace pelt::tools::bench {

/// The machine and the build of a measurement, as `pelt bench --json` writes them.
nlohmann::ordered_json machine_json();

}  // namespace pelt::tools::bench
