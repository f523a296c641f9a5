#include <pelt/self_collide.hpp>

#include "self_brute_force.hpp"

#include <gtest/gtest.h>

namespace pelt {
namespace {}  // namespace
}  // namespace pelt
