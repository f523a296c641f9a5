#pragma once

#include "text/message.hpp"

namespace pelt::asset {
using namespace text;
}
