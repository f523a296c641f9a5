#pragma once

#include "text/format.hpp"
#include "text/message.hpp"

namespace pelt::tools::output {
using namespace text;
}
