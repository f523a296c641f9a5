#pragma once

#include "text/json_text.hpp"

namespace pelt::tools::output {
using namespace text;
}
