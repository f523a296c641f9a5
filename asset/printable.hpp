#pragma once

#include "text/printable.hpp"

namespace pelt::asset {
using namespace text;
}
