#pragma once

#include "text/message.hpp"

namespace pelt::scenes {
using namespace text;
}
