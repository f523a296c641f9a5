#pragma once

#include <pelt/asset.hpp>

namespace pelt::test {

/// Does with a loaded file all that a program would, whatever is in it: builds the model, samples
/// its clips, poses it. True when all of it was accepted.
bool use_asset(const asset::Asset& asset);

}  // namespace pelt::test
